// Identity (a content hash) and bounds of a mesh, from the corners of its triangles. mesh_builder computes
// them from arrays, or VertexStream while the corners are sent and still in the caches. One thread at a time.
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

/// Bounds of the finite positions among `count`, which are `stride` floats apart. Reads one float beyond the
/// last position.
Bounds boundsOfFinite(const float* positions, uint32_t count, uint32_t stride);

constexpr uint32_t kIdentityPiece = 3 << 14;  // corners hashed as one

/// Hash of the corners' positions in triangle order, independent of which corners share vertices. `pieces`:
/// hashes of kIdentityPiece corners each; the last one covers the rest.
Hash128 identityOf(const std::vector<Hash128>& pieces, uint32_t triangles);

/// Facts about all triangles of a run.
struct SurfaceFacts {
  Hash128 identity;
  Bounds bounds;  // of all corners
  uint32_t corners = 0;
};

/// Computes the facts from corners that arrive in pieces.
class SurfaceWatch {
 public:
  /// Forgets all corners.
  void start();
  /// Ignores all further corners: facts() then returns false.
  void spoil() { spoiled_ = true; }
  bool spoiled() const { return spoiled_; }
  uint32_t corners() const { return corners_; }
  /// Adds corners whose positions are `stride` floats apart. Reads one float beyond the last. If memory runs
  /// out, it calls spoil().
  void add(const float* positions, uint32_t count, uint32_t stride) noexcept;
  /// Returns false if spoil() was called, or the corners make no whole triangles.
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
