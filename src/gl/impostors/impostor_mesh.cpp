// Builds meshes of impostors from the points or separate lines that a draw sends.
#include "gl/arrays/array_indices.h"
#include "gl/capture/mesh_builder.h"
#include "gl/impostors/sent_billboards.h"

#include <algorithm>
#include <cstring>

namespace gluray::gl {
namespace {

/// The elements of `range` as floats; empty if the array is disabled.
scene::Attribute copyOf(const ArrayReader& reader, Range range, uint32_t floats, size_t& sizeBytes) {
  if (!reader.enabled()) return {};
  constexpr scene::Format formats[] = {scene::Format::float1, scene::Format::float2, scene::Format::float3,
                                       scene::Format::float4};
  const auto data = makePadded<float>(size_t{range.count()} * floats);
  for (uint32_t i = 0; i < range.count(); ++i) {
    float value[4];
    reader.read(range.lower + i, value);
    std::memcpy(&data[size_t{i} * floats], value, floats * sizeof(float));
  }
  sizeBytes += size_t{range.count()} * floats * sizeof(float);
  return {data, reinterpret_cast<const std::byte*>(data.get()), floats * 4, formats[floats - 1]};
}

/// Indices of the centres, relative to range.lower; empty if all centres are used in order.
scene::Attribute numbersOf(const Taken& taken, size_t& sizeBytes) {
  if (taken.numbers.size() == 0) return {};
  const auto data = makePadded<uint32_t>(taken.numbers.size());
  std::memcpy(data.get(), taken.numbers.data(), taken.numbers.size() * sizeof(uint32_t));
  sizeBytes += taken.numbers.size() * sizeof(uint32_t);
  return {data, reinterpret_cast<const std::byte*>(data.get()), 4, scene::Format::uint32};
}

Hash128 hashOf(const scene::Attribute& a, uint32_t count, Hash128 seed) {
  return a ? hashBytes(a.data, size_t{count} * a.stride, seed) : hashBytes("-", 1, seed);
}

}  // namespace

KnownMesh buildImpostorMesh(const RealGl& real, const ArrayState& arrays, GLenum mode,
                            const Elements& elements) {
  if (arrays.sentBillboards) return buildSentImpostors(real, arrays, mode, elements);
  const ArrayReader centers(real, arrays.vertex), radii(real, arrays.radius), axes(real, arrays.axis),
      colors(real, arrays.color), texcoords(real, arrays.texcoord);
  uint32_t available = centers.available();
  for (const ArrayReader* r : {&radii, &axes, &colors, &texcoords})
    if (r->enabled()) available = std::min(available, r->available());
  const Taken taken = takenBy(real, arrays, mode, elements, available);
  auto mesh = std::make_shared<scene::Mesh>();
  const Range range = taken.range;
  KnownMesh result;
  for (uint32_t i = range.lower; i < range.upper && arrays.vertex.size == 4; ++i) {
    float position[4];
    centers.read(i, position);
    result.homogeneous = result.homogeneous || position[3] != 1;
  }
  if (result.homogeneous) return result;
  mesh->shape = arrays.shape;
  mesh->vertexCount = range.count();
  mesh->positions = copyOf(centers, range, 3, mesh->sizeBytes);
  mesh->radii = copyOf(radii, range, 1, mesh->sizeBytes);
  mesh->axes = copyOf(axes, range, 3, mesh->sizeBytes);
  mesh->colors = copyOf(colors, range, 4, mesh->sizeBytes);
  mesh->texcoords = copyOf(texcoords, range, 4, mesh->sizeBytes);
  mesh->indices = numbersOf(taken, mesh->sizeBytes);
  const size_t corners = mesh->indices ? taken.numbers.size() : range.count();
  mesh->triangleCount = static_cast<uint32_t>(corners / scene::cornersOf(mesh->shape));
  mesh->radius = arrays.impostorRadius;
  finishMesh(*mesh);
  const float form[] = {static_cast<float>(mesh->shape), mesh->radii ? 0 : mesh->radius};
  mesh->geometryId = hashBytes(form, sizeof form, mesh->geometryId);
  mesh->geometryId = hashOf(mesh->radii, mesh->vertexCount, mesh->geometryId);
  mesh->geometryId = hashOf(mesh->axes, mesh->vertexCount, mesh->geometryId);
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace gluray::gl
