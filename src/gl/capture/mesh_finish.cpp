// Properties of a mesh that its arrays determine: bounds, identity, opacity (mesh_builder.h).
#include "gl/capture/mesh_builder.h"
#include "parallel/loops.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
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

/// Hashes the pieces of the mesh on all cores.
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

bool allOpaque(const scene::Attribute& colors, uint32_t count) {
  if (!colors || colors.format == scene::Format::float3) return true;
  for (uint32_t i = 0; i < count; ++i)
    if (scene::fetch(colors, i).a != 1.0f) return false;
  return true;
}

constexpr uint32_t kMagnitude = 0x7fffffffu;  // of a float's bits; those of larger numbers and NaN are larger

/// The maximum of `most` and the largest magnitude of the elements' components, as bits.
template <uint32_t kComponents>
uint32_t largestBits(const scene::Attribute& a, size_t first, size_t last, uint32_t most) {
  const auto bitsOf = [&](size_t i) { return reinterpret_cast<const uint32_t*>(a.data + i * a.stride); };
  if (a.stride == kComponents * sizeof(float)) {
    const uint32_t* const bits = bitsOf(first);
    for (size_t i = 0; i < (last - first) * kComponents; ++i) most = std::max(most, bits[i] & kMagnitude);
    return most;
  }
  for (size_t i = first; i < last; ++i)
    for (uint32_t c = 0; c < kComponents; ++c) most = std::max(most, bitsOf(i)[c] & kMagnitude);
  return most;
}

/// Whether no component of the elements is NaN, infinite, or so large that its square may be infinite.
bool isModerate(const scene::Attribute& a, size_t count) {
  constexpr uint32_t kLimit = std::bit_cast<uint32_t>(1e15f);
  const auto within = [&](auto&& largest) {
    const auto larger = [](uint32_t x, uint32_t y) { return std::max(x, y); };
    const auto piece = [&](size_t first, size_t last, uint32_t most) {
      return largest(a, first, last, most);
    };
    return reducePieces(count, kBoundsGrain, uint32_t{0}, piece, larger) <= kLimit;
  };
  switch (a.format) {
    case scene::Format::float1: return within(largestBits<1>);
    case scene::Format::float2: return within(largestBits<2>);
    case scene::Format::float3: return within(largestBits<3>);
    case scene::Format::float4: return within(largestBits<4>);
    default: return true;
  }
}

bool areModerate(const scene::Mesh& mesh) {
  const size_t count = mesh.vertexCount;
  for (const scene::Attribute* a :
       {&mesh.normals, &mesh.colors, &mesh.texcoords, &mesh.secondaryColors, &mesh.fogCoords, &mesh.axes})
    if (!isModerate(*a, count)) return false;
  return std::ranges::all_of(mesh.texcoordsAbove, [&](const auto& a) { return isModerate(a, count); });
}

}  // namespace

float squareOfNormal(const glm::vec3& normal) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  return normal == glm::vec3(0) ? kInfinity : glm::dot(normal, normal);
}

float leastSquareOfNormals(const scene::Mesh& mesh) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  if (!mesh.normals || mesh.normals.format != scene::Format::float3) return kInfinity;
  return reducePieces(
      mesh.vertexCount, kBoundsGrain, kInfinity,
      [&](size_t first, size_t last, float least) {
        for (size_t i = first; i < last; ++i) {
          glm::vec3 normal;
          std::memcpy(&normal, mesh.normals.data + i * mesh.normals.stride, sizeof normal);
          least = std::min(least, squareOfNormal(normal));
        }
        return least;
      },
      [](float a, float b) { return std::min(a, b); });
}

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
