// Computes the identity and bounds of a mesh from the corners of its triangles. Computed by mesh_builder from
// arrays, or by VertexStream while the corners are sent and still in the caches. One thread at a time.
#pragma once
#include "base/hash.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

namespace gluray::gl {

struct Bounds {
  glm::vec3 lower{INFINITY}, upper{-INFINITY};
  void join(const Bounds& o) { lower = glm::min(lower, o.lower), upper = glm::max(upper, o.upper); }
};

/// Bounds of those of `count` positions, `stride` floats apart, that are finite. Reads a float beyond the
/// last.
Bounds boundsOfFinite(const float* positions, uint32_t count, uint32_t stride);

constexpr uint32_t kIdentityPiece = 3 << 14;  // corners hashed as one

/// Hash of corners' positions in triangle order. It does not depend on which corners share vertices.
/// `pieces`: hashes of kIdentityPiece corners each; the last has the rest.
Hash128 identityOf(const std::vector<Hash128>& pieces, uint32_t triangles);

/// Of all triangles of a run.
struct SurfaceFacts {
  Hash128 identity;
  Bounds bounds;  // of corners
  uint32_t corners = 0;
};

/// Collects facts of corners that come in pieces.
class SurfaceWatch {
 public:
  /// Forgets all corners.
  void start();
  /// The corners from here on are not seen: facts() returns none.
  void spoil() { spoiled_ = true; }
  bool spoiled() const { return spoiled_; }
  uint32_t corners() const { return corners_; }
  /// Adds corners whose positions are `stride` floats apart. Reads a float beyond the last. Without memory it
  /// spoils the facts.
  void add(const float* positions, uint32_t count, uint32_t stride) noexcept;
  /// False if they were spoiled, or the corners make no whole triangles.
  bool facts(SurfaceFacts&);

 private:
  void addToPiece(const float* positions, uint32_t count, uint32_t stride);

  bool spoiled_ = false;
  uint32_t corners_ = 0;
  HashStream piece_;  // the hash of corners_ % kIdentityPiece corners
  std::vector<Hash128> pieces_;
  Bounds bounds_;
};

}  // namespace gluray::gl
