#include "gl/capture/mesh_builder.h"

#include "base/timeline.h"
#include "gl/welding/weld.h"
#include "parallel/loops.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

namespace gluray::gl {

template <class T>
std::shared_ptr<T[]> makePadded(size_t count) {
  return std::make_shared_for_overwrite<T[]>(count + (16 + sizeof(T) - 1) / sizeof(T));
}
template std::shared_ptr<float[]> makePadded<float>(size_t);
template std::shared_ptr<uint32_t[]> makePadded<uint32_t>(size_t);

namespace {

constexpr size_t kMeshGrain = 1 << 16;

/// Maps mesh vertex i to its captured vertex: vertex i itself, or its representative after welding.
struct Selection {
  const CapturedVertices& captured;
  const GrowingArray<uint32_t>* source;  // null: all vertices in order
  uint32_t count() const { return source ? static_cast<uint32_t>(source->size()) : captured.vertexCount; }
  const float* operator[](uint32_t i) const { return captured.vertex(source ? (*source)[i] : i); }
};

/// Copies one slot into an array of its own.
scene::Attribute copySlot(const Selection& vertices, Slot slot, scene::Format format, size_t& sizeBytes) {
  const uint32_t floats = sizeOf(slot), offset = vertices.captured.layout.offset[slot],
                 count = vertices.count();
  const auto data = makePadded<float>(size_t{count} * floats);
  forPieces(count, kMeshGrain, [&](size_t first, size_t last) {
    for (size_t i = first; i < last; ++i)
      std::memcpy(&data[i * floats], vertices[static_cast<uint32_t>(i)] + offset, floats * 4);
  });
  sizeBytes += size_t{count} * floats * 4;
  return {data, reinterpret_cast<const std::byte*>(data.get()), floats * 4, format};
}

/// Copies colours as bytes if these are exact (a quarter of the memory), else as floats.
scene::Attribute copyColors(const Selection& vertices, size_t& sizeBytes) {
  const uint32_t offset = vertices.captured.layout.offset[kColor], count = vertices.count();
  const auto asByte = [](float c) {
    return static_cast<uint32_t>(std::lround(std::clamp(c, 0.0f, 1.0f) * 255.0f));
  };
  for (uint32_t i = 0; i < count; ++i) {
    const float* c = vertices[i] + offset;
    for (int k = 0; k < 4; ++k)
      if (!(static_cast<float>(asByte(c[k])) * (1.0f / 255.0f) == c[k] ||
            static_cast<float>(asByte(c[k])) / 255.0f == c[k]))
        return copySlot(vertices, kColor, scene::Format::float4, sizeBytes);
  }
  const auto data = makePadded<uint32_t>(count);
  for (uint32_t i = 0; i < count; ++i) {
    const float* c = vertices[i] + offset;
    data[i] = asByte(c[0]) | asByte(c[1]) << 8 | asByte(c[2]) << 16 | asByte(c[3]) << 24;
  }
  sizeBytes += size_t{count} * 4;
  return {data, reinterpret_cast<const std::byte*>(data.get()), 4, scene::Format::unorm8x4};
}

scene::Attribute copyMaterials(const Selection& vertices, size_t& sizeBytes) {
  const uint32_t offset = vertices.captured.layout.offset[kMaterialNumber], count = vertices.count();
  const auto data = makePadded<uint32_t>(count);
  for (uint32_t i = 0; i < count; ++i) data[i] = static_cast<uint32_t>(vertices[i][offset]);
  sizeBytes += size_t{count} * 4;
  return {data, reinterpret_cast<const std::byte*>(data.get()), 4, scene::Format::uint32};
}

/// Makes an index array that takes over the memory of `corners`.
scene::Attribute makeIndices(GrowingArray<uint32_t> corners, size_t& sizeBytes) {
  corners.shrink(corners.size());
  sizeBytes += corners.size() * 4;
  const auto data = std::make_shared<GrowingArray<uint32_t>>(std::move(corners));
  return {data, reinterpret_cast<const std::byte*>(data->data()), 4, scene::Format::uint32};
}

scene::Attribute makeIndices(std::vector<uint32_t> corners, size_t& sizeBytes) {
  corners.reserve(corners.size() + 4);  // 16 readable bytes after the last
  sizeBytes += corners.size() * 4;
  const auto data = std::make_shared<std::vector<uint32_t>>(std::move(corners));
  return {data, reinterpret_cast<const std::byte*>(data->data()), 4, scene::Format::uint32};
}

GrowingArray<uint32_t> copyOf(const GrowingArray<uint32_t>& numbers) {
  GrowingArray<uint32_t> copy;
  copy.resize(numbers.size());
  copyLarge(copy.data(), numbers.data(), numbers.size() * sizeof(uint32_t));
  return copy;
}

/// Whether the capture is one primitive of separate triangles.
bool isTriangles(const CapturedVertices& c) {
  return c.primitives.size() == 1 && c.primitives[0].mode == GL_TRIANGLES && c.primitives[0].first == 0;
}

/// Whether the capture is one primitive of separate triangles without indices.
bool isSoup(const CapturedVertices& c) { return c.indices.empty() && isTriangles(c); }

/// Whether a mesh can use vertices of this layout in place, and needs all of their slots.
bool isReadable(const VertexLayout& layout) {
  return (layout.mask &
          ~(bit(kPosition) | bit(kNormal) | bit(kSecondaryColor) | bit(kFogCoord) | kTexCoordSlots)) == 0;
}

/// Texture coordinates of units 1 to 7; calls makeOne(slot) for each unit that the layout has.
template <class MakeOne>
std::vector<scene::Attribute> texcoordsAbove(const VertexLayout& layout, MakeOne&& makeOne) {
  std::vector<scene::Attribute> all;
  for (uint32_t unit = 1; unit < 8; ++unit) {
    if (!layout.has(texCoordSlot(unit))) continue;
    all.resize(unit);
    all.back() = makeOne(texCoordSlot(unit));
  }
  return all;
}

bool hasOtherW(const CapturedVertices& c) {
  if (!c.layout.has(kPositionW)) return false;
  for (uint32_t i = 0; i < c.vertexCount; ++i)
    if (c.vertex(i)[c.layout.offset[kPositionW]] != 1.0f) return true;
  return false;
}

/// Whether the capture holds points or lines.
bool isOfSolids(const CapturedVertices& c) {
  return !c.primitives.empty() && classOf(c.primitives.front().mode) != PrimitiveClass::surfaces;
}

/// Whether the capture has lines or triangles with adjacent vertices, for which no mesh is built.
bool hasAdjacency(const CapturedVertices& c) {
  return std::any_of(c.primitives.begin(), c.primitives.end(),
                     [](const Primitive& p) { return p.mode > GL_POLYGON; });
}

/// Makes balls from points, capsules from lines.
void makeSolids(const CapturedVertices& captured, scene::Mesh& mesh) {
  const bool points = classOf(captured.primitives.front().mode) == PrimitiveClass::points;
  mesh.shape = points ? scene::Shape::balls : scene::Shape::capsules;
  std::vector<uint32_t> corners = solidCorners(captured);
  mesh.triangleCount = static_cast<uint32_t>(corners.size() / scene::cornersOf(mesh.shape));
  mesh.indices = makeIndices(std::move(corners), mesh.sizeBytes);
}

void copyAttributes(const Selection& vertices, scene::Mesh& mesh) {
  const VertexLayout& layout = vertices.captured.layout;
  mesh.vertexCount = vertices.count();
  mesh.positions = copySlot(vertices, kPosition, scene::Format::float3, mesh.sizeBytes);
  if (layout.has(kNormal)) mesh.normals = copySlot(vertices, kNormal, scene::Format::float3, mesh.sizeBytes);
  if (layout.has(kColor)) mesh.colors = copyColors(vertices, mesh.sizeBytes);
  if (layout.has(kSecondaryColor))
    mesh.secondaryColors = copySlot(vertices, kSecondaryColor, scene::Format::float3, mesh.sizeBytes);
  if (layout.has(kFogCoord))
    mesh.fogCoords = copySlot(vertices, kFogCoord, scene::Format::float1, mesh.sizeBytes);
  if (layout.has(kTexCoord0))
    mesh.texcoords = copySlot(vertices, kTexCoord0, scene::Format::float4, mesh.sizeBytes);
  mesh.texcoordsAbove = texcoordsAbove(
      layout, [&](Slot s) { return copySlot(vertices, s, scene::Format::float4, mesh.sizeBytes); });
  if (layout.has(kMaterialNumber)) mesh.materials = copyMaterials(vertices, mesh.sizeBytes);
}

}  // namespace

KnownMesh buildMesh(const CapturedVertices& captured) {
  constexpr uint32_t kWorthWelding = 3000;  // vertices
  KnownMesh result;
  if (hasOtherW(captured)) {
    result.homogeneous = true;
    return result;
  }
  if (hasAdjacency(captured)) return result;
  auto mesh = std::make_shared<scene::Mesh>();
  if (isOfSolids(captured)) {
    copyAttributes({captured, nullptr}, *mesh);
    makeSolids(captured, *mesh);
  } else if (isSoup(captured) && captured.vertexCount < kWorthWelding) {
    copyAttributes({captured, nullptr}, *mesh);
    mesh->triangleCount = captured.vertexCount / 3;
  } else if (isSoup(captured)) {
    const timeline::Span span("weld", captured.vertexCount / 3);
    Welded welded = weld(captured.vertices.data(), captured.vertexCount, captured.layout.stride);
    copyAttributes({captured, &welded.source}, *mesh);
    mesh->indices = makeIndices(std::move(welded.index), mesh->sizeBytes);
    mesh->triangleCount = captured.vertexCount / 3;
  } else if (isTriangles(captured)) {
    copyAttributes({captured, nullptr}, *mesh);
    mesh->indices = makeIndices(copyOf(captured.indices), mesh->sizeBytes);
    mesh->triangleCount = static_cast<uint32_t>(captured.indices.size() / 3);
  } else {
    std::vector<uint32_t> triangles = triangulate(captured);
    mesh->triangleCount = static_cast<uint32_t>(triangles.size() / 3);
    copyAttributes({captured, nullptr}, *mesh);
    mesh->indices = makeIndices(std::move(triangles), mesh->sizeBytes);
  }
  finishMesh(*mesh);
  if (mesh->shape != scene::Shape::triangles) mesh->geometryId = hashBytes(&mesh->shape, 1, mesh->geometryId);
  result.leastSquareOfNormals = leastSquareOfNormals(*mesh);
  result.mesh = std::move(mesh);
  return result;
}

KnownMesh buildMesh(CapturedVertices&& captured) {
  const bool asIs = isTriangles(captured) && !captured.indices.empty() && isReadable(captured.layout);
  if (!asIs) return buildMesh(std::as_const(captured));
  struct Taken {
    GrowingArray<float> vertices;
    GrowingArray<uint32_t> indices;
  };
  const auto taken = std::make_shared<Taken>();
  const VertexLayout& layout = captured.layout;
  captured.vertices.shrink(size_t{captured.vertexCount} * layout.stride);
  captured.indices.shrink(captured.indices.size());
  auto mesh = std::make_shared<scene::Mesh>();
  const auto slot = [&](Slot s, scene::Format format) -> scene::Attribute {
    if (!layout.has(s)) return {};
    const float* first = captured.vertices.data() + layout.offset[s];
    return {taken, reinterpret_cast<const std::byte*>(first), layout.stride * uint32_t{sizeof(float)},
            format};
  };
  mesh->vertexCount = captured.vertexCount;
  mesh->triangleCount = static_cast<uint32_t>(captured.indices.size() / 3);
  mesh->positions = slot(kPosition, scene::Format::float3);
  mesh->normals = slot(kNormal, scene::Format::float3);
  mesh->secondaryColors = slot(kSecondaryColor, scene::Format::float3);
  mesh->fogCoords = slot(kFogCoord, scene::Format::float1);
  mesh->texcoords = slot(kTexCoord0, scene::Format::float4);
  mesh->texcoordsAbove = texcoordsAbove(layout, [&](Slot s) { return slot(s, scene::Format::float4); });
  mesh->indices = {taken, reinterpret_cast<const std::byte*>(captured.indices.data()), 4,
                   scene::Format::uint32};
  mesh->sizeBytes = captured.sizeBytes();
  finishMesh(*mesh, captured.facts ? &*captured.facts : nullptr);
  // Moving the arrays leaves their elements where they are; nothing can fail from here on.
  taken->vertices = std::move(captured.vertices);
  taken->indices = std::move(captured.indices);
  KnownMesh result;
  result.leastSquareOfNormals = leastSquareOfNormals(*mesh);
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace gluray::gl
