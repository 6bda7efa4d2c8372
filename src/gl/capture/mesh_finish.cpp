// What the arrays of a mesh tell: bounds, identity, opacity (mesh_builder.h).
#include "gl/capture/mesh_builder.h"
#include "parallel/loops.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace gluray::gl {
namespace {

constexpr size_t kBoundsGrain = 1 << 16;  // vertices

Bounds boundsOf(const scene::Mesh& mesh) {
  const auto* positions = reinterpret_cast<const float*>(mesh.positions.data);
  const uint32_t stride = mesh.positions.stride / 4;
  return reducePieces(
      mesh.vertexCount, kBoundsGrain, Bounds{},
      [&](size_t first, size_t last, Bounds b) {
        b.join(boundsOfFinite(positions + first * stride, static_cast<uint32_t>(last - first), stride));
        return b;
      },
      [](Bounds a, const Bounds& b) {
        a.join(b);
        return a;
      });
}

/// Computes the hashes of pieces on all cores.
Hash128 geometryIdentity(const scene::Mesh& mesh) {
  constexpr uint32_t kTriangles = kIdentityPiece / 3, kPacked = 64;
  const uint32_t pieces = (mesh.triangleCount + kTriangles - 1) / kTriangles;
  std::vector<Hash128> hashes(pieces);
  const auto hashPiece = [&](uint32_t piece, HashStream& stream) {
    const uint32_t first = piece * kTriangles, last = std::min(mesh.triangleCount, first + kTriangles);
    glm::vec3 corners[3 * kPacked];
    for (uint32_t from = first; from < last; from += kPacked) {
      const uint32_t to = std::min(last, from + kPacked);
      glm::vec3* corner = corners;
      for (uint32_t t = from; t < to; ++t)
        for (uint32_t k = 0; k < 3; ++k) *corner++ = mesh.position(mesh.corner(t, k));
      stream.add(corners, static_cast<size_t>(corner - corners) * sizeof(glm::vec3));
    }
    hashes[piece] = stream.finishHash();
  };
  forPieces(pieces, 1, [&](size_t piece, size_t last) {
    HashStream stream;
    for (; piece < last; ++piece) hashPiece(static_cast<uint32_t>(piece), stream);
  });
  return identityOf(hashes, mesh.triangleCount);
}

uint32_t componentsOf(scene::Format format) {
  switch (format) {
    case scene::Format::float1: return 1;
    case scene::Format::float2: return 2;
    case scene::Format::float3: return 3;
    case scene::Format::float4: return 4;
    default: return 0;
  }
}

bool allOpaque(const scene::Attribute& colors, uint32_t count) {
  if (!colors || colors.format == scene::Format::float3) return true;
  for (uint32_t i = 0; i < count; ++i)
    if (scene::fetch(colors, i).a != 1.0f) return false;
  return true;
}

/// Whether no component of the elements is NaN, infinite, or so large that its square may be.
bool isModerate(const scene::Attribute& a, size_t count) {
  constexpr uint32_t kMagnitude = 0x7fffffffu, kLimit = std::bit_cast<uint32_t>(1e15f);
  const uint32_t components = componentsOf(a.format);
  if (components == 0) return true;
  const auto largest = [&](size_t first, size_t last, uint32_t most) {
    for (size_t i = first; i < last; ++i) {
      const auto* bits = reinterpret_cast<const uint32_t*>(a.data + i * a.stride);
      for (uint32_t c = 0; c < components; ++c) most = std::max(most, bits[c] & kMagnitude);
    }
    return most;
  };
  const auto larger = [](uint32_t x, uint32_t y) { return std::max(x, y); };
  return reducePieces(count, kBoundsGrain, uint32_t{0}, largest, larger) <= kLimit;
}

bool areModerate(const scene::Mesh& mesh) {
  const size_t count = mesh.vertexCount;
  for (const scene::Attribute* a :
       {&mesh.normals, &mesh.colors, &mesh.texcoords, &mesh.secondaryColors, &mesh.fogCoords, &mesh.axes})
    if (!isModerate(*a, count)) return false;
  return std::ranges::all_of(mesh.texcoordsAbove, [&](const auto& a) { return isModerate(a, count); });
}

}  // namespace

bool isFarAway(const scene::Mesh& mesh) {
  constexpr float kFarthest = 1e18f;
  const glm::vec3 reach = glm::max(glm::abs(mesh.lower), glm::abs(mesh.upper));
  return std::max({reach.x, reach.y, reach.z}) > kFarthest;
}

void finishMesh(scene::Mesh& mesh, const SurfaceFacts* facts) {
  const bool known = facts && facts->corners == uint64_t{mesh.triangleCount} * 3;
  const Bounds bounds = known ? facts->bounds : boundsOf(mesh);
  if (bounds.lower.x <= bounds.upper.x) mesh.lower = bounds.lower, mesh.upper = bounds.upper;
  mesh.geometryId = known ? facts->identity : geometryIdentity(mesh);
  mesh.opaqueColors = allOpaque(mesh.colors, mesh.vertexCount);
  mesh.moderate = areModerate(mesh);
}

}  // namespace gluray::gl
