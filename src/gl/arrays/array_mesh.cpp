// Builds meshes and captures from vertex arrays.
#include "gl/arrays/array_indices.h"
#include "gl/capture/mesh_builder.h"
#include "parallel/loops.h"

#include <bit>
#include <cstring>

namespace gluray::gl {
namespace {

constexpr size_t kGrain = 1 << 14;  // elements

struct Readers {
  Readers(const RealGl& real, const ArrayState& arrays, Fractions fractions = Fractions::ofArrays)
      : vertex(real, arrays.vertex, fractions),
        normal(real, arrays.normal, fractions),
        color(real, arrays.color, fractions),
        secondaryColor(real, arrays.secondaryColor, fractions),
        fogCoord(real, arrays.fogCoord, fractions),
        texcoord(real, arrays.texcoord, fractions) {
    for (const ArraySource& source : arrays.texcoordsAbove)
      texcoordsAbove.emplace_back(real, source, fractions);
  }
  ArrayReader vertex, normal, color, secondaryColor, fogCoord, texcoord;
  std::vector<ArrayReader> texcoordsAbove;

  /// Number of elements that every enabled array has.
  uint32_t available() const {
    uint32_t n = vertex.available();
    for (const ArrayReader* r : {&normal, &color, &secondaryColor, &fogCoord, &texcoord})
      if (r->enabled()) n = std::min(n, r->available());
    for (const ArrayReader& r : texcoordsAbove)
      if (r.enabled()) n = std::min(n, r.available());
    return n;
  }
};

bool isAligned(const ArrayReader& reader, const ArraySource& source) {
  return reinterpret_cast<uintptr_t>(reader.data()) % 4 == 0 && source.stride % 4 == 0;
}

/// The array from element `first` on, used in place; empty if the renderer cannot read its format.
scene::Attribute inPlace(const ArrayReader& reader, const ArraySource& source, uint32_t first, bool color) {
  if (!reader.storage() || !isAligned(reader, source)) return {};
  scene::Format format = scene::Format::none;
  if (source.type == GL_FLOAT) {
    constexpr scene::Format floats[] = {scene::Format::float1, scene::Format::float2, scene::Format::float3,
                                        scene::Format::float4};
    format = floats[source.size - 1];
  } else if (color && source.normalized && source.type == GL_UNSIGNED_BYTE && source.size == 4) {
    format = scene::Format::unorm8x4;
  }
  const auto stride = static_cast<uint32_t>(source.stride);
  return {reader.storage(), reader.data() + size_t{first} * stride, stride, format};
}

/// Copies the elements of `range` as `floats` floats each; element i goes to target + i * step.
void copyElements(const ArrayReader& reader, const ArraySource& source, Range range, uint32_t floats,
                  float* target, uint32_t step) {
  const bool plain = source.type == GL_FLOAT && source.size >= static_cast<GLint>(floats);
  const auto stride = static_cast<size_t>(source.stride);
  if (plain && step == floats && stride == floats * sizeof(float))
    return copyLarge(target, reader.data() + range.lower * stride, size_t{range.count()} * stride);
  forPieces(range.count(), kGrain, [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i) {
      const uint32_t element = range.lower + static_cast<uint32_t>(i);
      float value[4];
      if (plain)
        std::memcpy(value, reader.data() + element * stride, floats * sizeof(float));
      else
        reader.read(element, value);
      std::memcpy(target + i * step, value, floats * sizeof(float));
    }
  });
}

/// A copy of the elements of `range` as floats.
scene::Attribute copied(const ArrayReader& reader, const ArraySource& source, Range range, uint32_t floats,
                        size_t& sizeBytes) {
  constexpr scene::Format formats[] = {scene::Format::float1, scene::Format::float2, scene::Format::float3,
                                       scene::Format::float4};
  const auto data = makePadded<float>(size_t{range.count()} * floats);
  copyElements(reader, source, range, floats, data.get(), floats);
  sizeBytes += size_t{range.count()} * floats * sizeof(float);
  return {data, reinterpret_cast<const std::byte*>(data.get()), floats * 4, formats[floats - 1]};
}

/// An attribute of the mesh: used in place if `keepPlace` and its format allow it, else a copy.
scene::Attribute attribute(const ArrayReader& reader, const ArraySource& source, Range range, bool keepPlace,
                           uint32_t floats, size_t& sizeBytes) {
  if (!reader.enabled()) return {};
  if (keepPlace)
    if (const auto here = inPlace(reader, source, range.lower, floats == 4)) return here;
  return copied(reader, source, range, floats, sizeBytes);
}

bool anyOtherW(const ArrayReader& reader, const ArraySource& source, Range range) {
  if (source.size < 4) return false;
  return reducePieces(
      range.count(), kGrain, false,
      [&](size_t first, size_t last, bool found) {
        for (size_t i = first; i < last && !found; ++i) {
          float v[4];
          reader.read(range.lower + static_cast<uint32_t>(i), v);
          found = v[3] != 1.0f;
        }
        return found;
      },
      [](bool a, bool b) { return a || b; });
}

/// The indices of a mesh whose first vertex is array element `lower`; empty if the corners are in order.
scene::Attribute indicesFor(const Triangles& triangles, uint32_t lower, size_t& sizeBytes) {
  if (triangles.inOrder) return {};
  const PlainIndices& plain = triangles.plain;
  if (plain.storage && lower == 0)
    return {plain.storage, reinterpret_cast<const std::byte*>(plain.data), 4, scene::Format::uint32};
  const uint32_t* numbers = plain.data ? plain.data : triangles.numbers.data();
  const auto data = makePadded<uint32_t>(triangles.corners);
  copyNumbers(data.get(), numbers, triangles.corners, lower);
  sizeBytes += triangles.corners * 4;
  return {data, reinterpret_cast<const std::byte*>(data.get()), 4, scene::Format::uint32};
}

bool allInBuffers(const ArrayState& arrays) {
  bool all = true;
  arrays.forEach([&](const ArraySource& s) { all = all && (!s.enabled || s.buffer); });
  return all;
}

}  // namespace

KnownMesh buildArrayMesh(const RealGl& real, const ArrayState& arrays, GLenum mode,
                         const Elements& elements) {
  const Readers readers(real, arrays);
  const Triangles triangles = trianglesOf(real, arrays, mode, elements, readers.available());
  Range range = triangles.range;
  KnownMesh result;
  result.homogeneous = anyOtherW(readers.vertex, arrays.vertex, range);
  if (result.homogeneous) return result;
  auto mesh = std::make_shared<scene::Mesh>();
  // Positions are read in place as three floats; the stride skips a fourth, which is 1.
  const bool keepPlace = allInBuffers(arrays) && arrays.vertex.type == GL_FLOAT && arrays.vertex.size >= 3 &&
                         isAligned(readers.vertex, arrays.vertex);
  if (keepPlace && !triangles.inOrder) range.lower = 0;
  mesh->vertexCount = range.count();
  mesh->triangleCount = static_cast<uint32_t>(triangles.corners / 3);
  mesh->positions = attribute(readers.vertex, arrays.vertex, range, keepPlace, 3, mesh->sizeBytes);
  mesh->positions.format = scene::Format::float3;
  mesh->normals = attribute(readers.normal, arrays.normal, range, keepPlace, 3, mesh->sizeBytes);
  mesh->colors = attribute(readers.color, arrays.color, range, keepPlace, 4, mesh->sizeBytes);
  mesh->secondaryColors =
      attribute(readers.secondaryColor, arrays.secondaryColor, range, keepPlace, 3, mesh->sizeBytes);
  mesh->fogCoords = attribute(readers.fogCoord, arrays.fogCoord, range, keepPlace, 1, mesh->sizeBytes);
  mesh->texcoords = attribute(readers.texcoord, arrays.texcoord, range, keepPlace, 4, mesh->sizeBytes);
  for (size_t i = 0; i < arrays.texcoordsAbove.size(); ++i)
    mesh->texcoordsAbove.push_back(
        attribute(readers.texcoordsAbove[i], arrays.texcoordsAbove[i], range, keepPlace, 4, mesh->sizeBytes));
  mesh->indices = indicesFor(triangles, range.lower, mesh->sizeBytes);
  finishMesh(*mesh);
  result.leastSquareOfNormals = leastSquareOfNormals(*mesh);
  result.mesh = std::move(mesh);
  return result;
}

CapturedVertices capture(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& elements,
                         Fractions fractions) {
  const Readers readers(real, arrays, fractions);
  Taken taken = takenBy(real, arrays, mode, elements, readers.available());
  const Range range = taken.range;
  CapturedVertices result;
  const bool homogeneous = anyOtherW(readers.vertex, arrays.vertex, range);
  const VertexLayout& layout = result.layout =
      VertexLayout::layoutOf(slotsOf(arrays) | (homogeneous ? bit(kPositionW) : 0));
  result.vertexCount = range.count();
  result.vertices.reserve(size_t{range.count()} * layout.stride);
  const auto put = [&](Slot slot, const ArrayReader& reader, const ArraySource& source) {
    if (reader.enabled())
      copyElements(reader, source, range, sizeOf(slot), result.vertices.data() + layout.offset[slot],
                   layout.stride);
  };
  put(kPosition, readers.vertex, arrays.vertex);
  put(kNormal, readers.normal, arrays.normal);
  put(kColor, readers.color, arrays.color);
  put(kSecondaryColor, readers.secondaryColor, arrays.secondaryColor);
  put(kFogCoord, readers.fogCoord, arrays.fogCoord);
  put(kTexCoord0, readers.texcoord, arrays.texcoord);
  for (size_t i = 0; i < arrays.texcoordsAbove.size(); ++i)
    put(texCoordSlot(static_cast<uint32_t>(i) + 1), readers.texcoordsAbove[i], arrays.texcoordsAbove[i]);
  for (uint32_t i = 0; homogeneous && i < range.count(); ++i) {
    float position[4];
    readers.vertex.read(range.lower + i, position);
    result.vertex(i)[layout.offset[kPositionW]] = position[3];
  }
  const auto count = elements.type ? static_cast<uint32_t>(taken.numbers.size()) : range.count();
  if (count > 0) result.primitives.push_back({mode, 0, count});
  result.indices = std::move(taken.numbers);
  return result;
}

namespace {

/// Hashes the identity of an array's content: its buffer's version, or the bytes that the draw reads.
Hash128 hashArray(const ArraySource& source, Range range, Hash128 h) {
  if (!source.enabled) return hashBytes("-", 1, h);
  const int64_t form[] = {
      source.size,
      source.type,
      source.stride,
      source.normalized,
      source.symmetric,
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
  return hashLarge(source.pointer + range.lower * stride,
                   (range.count() - 1) * stride + component * static_cast<size_t>(source.size), h);
}

}  // namespace

Hash128 contentOf(const RealGl& real, const ArrayState& arrays, GLenum mode, const Elements& e) {
  const bool buffers = allInBuffers(arrays) && (!e.type || arrays.elements);
  const int64_t form[] = {mode,
                          e.first,
                          e.count,
                          e.type,
                          e.base,
                          buffers,
                          static_cast<int64_t>(arrays.shape),
                          std::bit_cast<int32_t>(arrays.impostorRadius),
                          std::bit_cast<int32_t>(arrays.impostorCaps)};
  Hash128 h = hashBytes(form, sizeof form);
  Range range;
  if (e.type && arrays.elements) {
    const uint64_t identity[] = {arrays.elements->serial(), arrays.elements->version(),
                                 reinterpret_cast<uintptr_t>(e.indices)};
    h = hashBytes(identity, sizeof identity, h);
  }
  if (!buffers) {
    const Order order = orderOf(real, arrays, mode, e, h);
    range = order.range;
    h = order.identity;
  }
  arrays.forEach([&](const ArraySource& s) { h = hashArray(s, range, h); });
  return h;
}

}  // namespace gluray::gl
