// Meshes and captures made of vertex arrays.
#include "gl/arrays.h"
#include "gl/mesh_builder.h"

#include <algorithm>
#include <cstring>

namespace gluray::gl {
namespace {

struct Readers {
  Readers(const RealGl& real, const ArrayState& arrays)
      : vertex(real, arrays.vertex),
        normal(real, arrays.normal),
        color(real, arrays.color),
        texcoord(real, arrays.texcoord) {}
  ArrayReader vertex, normal, color, texcoord;

  /// Elements that every enabled array has.
  uint32_t available() const {
    uint32_t n = vertex.available();
    for (const ArrayReader* r : {&normal, &color, &texcoord})
      if (r->enabled()) n = std::min(n, r->available());
    return n;
  }
};

struct Range {
  uint32_t lower = 0, upper = 0;  // first vertex, and one behind the last
  uint32_t count() const { return upper - lower; }
};

Range rangeOf(const std::vector<uint32_t>& numbers) {
  if (numbers.empty()) return {};
  const auto [lower, upper] = std::minmax_element(numbers.begin(), numbers.end());
  return {*lower, *upper + 1};
}

/// Cuts a list of triangle corners down to triangles whose vertices all exist.
void dropMissing(std::vector<uint32_t>& corners, uint32_t available) {
  size_t kept = 0;
  for (size_t t = 0; t + 2 < corners.size(); t += 3) {
    if (std::max({corners[t], corners[t + 1], corners[t + 2]}) >= available) continue;
    std::copy_n(corners.begin() + static_cast<ptrdiff_t>(t), 3,
                corners.begin() + static_cast<ptrdiff_t>(kept));
    kept += 3;
  }
  corners.resize(kept);
}

std::vector<uint32_t> corners(std::vector<uint32_t> numbers, GLenum mode) {
  Captured draw;
  draw.primitives.push_back({mode, 0, static_cast<uint32_t>(numbers.size())});
  draw.indices = std::move(numbers);
  return triangulate(draw);
}

bool isAligned(const ArrayReader& reader, const ArraySource& source) {
  return reinterpret_cast<uintptr_t>(reader.data()) % 4 == 0 && source.stride % 4 == 0;
}

/// The array where it lies, if renderers can read that form; absent otherwise.
scene::Attribute inPlace(const ArrayReader& reader, const ArraySource& source, bool color) {
  if (!reader.storage() || !isAligned(reader, source)) return {};
  scene::Format format = scene::Format::none;
  if (source.type == GL_FLOAT) {
    constexpr scene::Format floats[] = {scene::Format::float1, scene::Format::float2, scene::Format::float3,
                                        scene::Format::float4};
    format = floats[source.size - 1];
  } else if (color && source.type == GL_UNSIGNED_BYTE && source.size == 4) {
    format = scene::Format::unorm8x4;
  }
  return {reader.storage(), reader.data(), static_cast<uint32_t>(source.stride), format};
}

/// A copy as floats of the elements of `range`.
scene::Attribute copied(const ArrayReader& reader, Range range, uint32_t floats, size_t& sizeBytes) {
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

/// An attribute of the mesh: in place where everything is, else a copy.
scene::Attribute attribute(const ArrayReader& reader, const ArraySource& source, Range range, bool keepPlace,
                           uint32_t floats, size_t& sizeBytes) {
  if (!reader.enabled()) return {};
  if (keepPlace)
    if (const auto here = inPlace(reader, source, floats == 4)) return here;
  return copied(reader, range, floats, sizeBytes);
}

bool anyOtherW(const ArrayReader& reader, const ArraySource& source, Range range) {
  if (source.size < 4) return false;
  for (uint32_t i = range.lower; i < range.upper; ++i) {
    float v[4];
    reader.read(i, v);
    if (v[3] != 1.0f) return true;
  }
  return false;
}

/// The program's index array itself, where it is a list of triangles that exist.
scene::Attribute indicesInPlace(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e,
                                const std::vector<uint32_t>& triangles) {
  const auto offset = reinterpret_cast<uintptr_t>(e.indices);
  const bool same = mode == GL_TRIANGLES && e.type == GL_UNSIGNED_INT && e.base == 0 && arrays.elements &&
                    offset % 4 == 0 && triangles.size() == static_cast<size_t>(e.count / 3) * 3;
  if (!same) return {};
  const auto storage = arrays.elements->read(real);
  return {storage, storage->data + offset, 4, scene::Format::uint32};
}

bool allInBuffers(const ArrayState& arrays) {
  const auto isIn = [](const ArraySource& s) { return !s.enabled || s.buffer; };
  return isIn(arrays.vertex) && isIn(arrays.normal) && isIn(arrays.color) && isIn(arrays.texcoord);
}

}  // namespace

KnownMesh buildArrayMesh(const RealGl& real, const ArrayState& arrays, GLenum mode,
                         const Elements& elements) {
  const Readers readers(real, arrays);
  std::vector<uint32_t> triangles = corners(vertexNumbers(real, arrays, elements), mode);
  dropMissing(triangles, readers.available());
  Range range = rangeOf(triangles);
  KnownMesh result;
  result.homogeneous = anyOtherW(readers.vertex, arrays.vertex, range);
  if (result.homogeneous) return result;
  auto mesh = std::make_shared<scene::Mesh>();
  // Positions are read in place as three floats; a fourth is 1 and is skipped by the stride.
  const bool keepPlace = allInBuffers(arrays) && arrays.vertex.type == GL_FLOAT && arrays.vertex.size >= 3 &&
                         isAligned(readers.vertex, arrays.vertex);
  if (keepPlace) range.lower = 0;
  mesh->vertexCount = range.count();
  mesh->triangleCount = static_cast<uint32_t>(triangles.size() / 3);
  mesh->positions = attribute(readers.vertex, arrays.vertex, range, keepPlace, 3, mesh->sizeBytes);
  mesh->positions.format = scene::Format::float3;
  mesh->normals = attribute(readers.normal, arrays.normal, range, keepPlace, 3, mesh->sizeBytes);
  mesh->colors = attribute(readers.color, arrays.color, range, keepPlace, 4, mesh->sizeBytes);
  mesh->texcoords = attribute(readers.texcoord, arrays.texcoord, range, keepPlace, 4, mesh->sizeBytes);
  if (keepPlace) mesh->indices = indicesInPlace(real, arrays, mode, elements, triangles);
  if (!mesh->indices) {
    const auto data = makePadded<uint32_t>(triangles.size());
    std::transform(triangles.begin(), triangles.end(), data.get(),
                   [&](uint32_t i) { return i - range.lower; });
    mesh->indices = {data, reinterpret_cast<const std::byte*>(data.get()), 4, scene::Format::uint32};
    mesh->sizeBytes += triangles.size() * 4;
  }
  finishMesh(*mesh);
  result.mesh = std::move(mesh);
  return result;
}

Captured capture(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements) {
  const Readers readers(real, arrays);
  std::vector<uint32_t> numbers = vertexNumbers(real, arrays, elements);
  std::erase_if(numbers, [&](uint32_t i) { return i >= readers.available(); });
  const Range range = rangeOf(numbers);
  Captured result;
  const bool homogeneous = anyOtherW(readers.vertex, arrays.vertex, range);
  result.layout = VertexLayout::of(slotsOf(arrays) | (homogeneous ? bit(kPositionW) : 0));
  result.vertexCount = range.count();
  result.vertices.reserve(size_t{range.count()} * result.layout.stride);
  for (uint32_t i = 0; i < range.count(); ++i) {
    float* target = result.vertex(i);
    float value[4];
    readers.vertex.read(range.lower + i, value);
    std::memcpy(target, value, 3 * sizeof(float));
    if (homogeneous) target[result.layout.offset[kPositionW]] = value[3];
    const auto put = [&](Slot slot, const ArrayReader& reader) {
      if (!reader.enabled()) return;
      reader.read(range.lower + i, value);
      std::memcpy(target + result.layout.offset[slot], value, sizeOf(slot) * sizeof(float));
    };
    put(kNormal, readers.normal), put(kColor, readers.color), put(kTexCoord0, readers.texcoord);
  }
  for (uint32_t& n : numbers) n -= range.lower;
  if (!numbers.empty()) result.primitives.push_back({mode, 0, static_cast<uint32_t>(numbers.size())});
  if (elements.type) result.indices = std::move(numbers);
  return result;
}

namespace {

/// What identifies an array's contents: a version where a buffer holds it, otherwise the bytes that the draw
/// reads.
Hash128 hashArray(const ArraySource& source, Range range, Hash128 h) {
  if (!source.enabled) return hashBytes("-", 1, h);
  const int64_t form[] = {
      source.size, source.type, source.stride,
      static_cast<int64_t>(reinterpret_cast<uintptr_t>(source.buffer ? source.pointer : nullptr))};
  h = hashBytes(form, sizeof form, h);
  if (source.buffer) {
    const uint64_t identity[] = {source.buffer->serial(), source.buffer->version()};
    return hashBytes(identity, sizeof identity, h);
  }
  if (!source.pointer || range.count() == 0) return h;
  size_t component = 4;
  if (source.type == GL_DOUBLE)
    component = 8;
  else if (source.type == GL_BYTE || source.type == GL_UNSIGNED_BYTE)
    component = 1;
  else if (source.type == GL_SHORT || source.type == GL_UNSIGNED_SHORT)
    component = 2;
  const auto stride = static_cast<size_t>(source.stride);
  return hashBytes(source.pointer + range.lower * stride,
                   (range.count() - 1) * stride + component * static_cast<size_t>(source.size), h);
}

}  // namespace

Hash128 contentOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e) {
  const bool buffers = allInBuffers(arrays) && (!e.type || arrays.elements);
  const int64_t form[] = {mode, e.first, e.count, e.type, e.base, buffers};
  Hash128 h = hashBytes(form, sizeof form);
  Range range;
  if (e.type && arrays.elements) {
    const uint64_t identity[] = {arrays.elements->serial(), arrays.elements->version(),
                                 reinterpret_cast<uintptr_t>(e.indices)};
    h = hashBytes(identity, sizeof identity, h);
  }
  if (!buffers) {
    const std::vector<uint32_t> numbers = vertexNumbers(real, arrays, e);
    range = rangeOf(numbers);
    if (e.type) h = hashBytes(numbers.data(), numbers.size() * sizeof(uint32_t), h);
  }
  for (const ArraySource* s : {&arrays.vertex, &arrays.normal, &arrays.color, &arrays.texcoord})
    h = hashArray(*s, range, h);
  return h;
}

}  // namespace gluray::gl
