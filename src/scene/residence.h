// Loads the arrays of a page, a part of a mesh larger than memory, when a ray hits its bounds. Implemented by
// cluster/pages, called by accel/pages.
#pragma once
#include <glm/glm.hpp>

#include <cstddef>

namespace gluray::scene {

class Residence {
 public:
  virtual ~Residence() = default;
  /// Fills the mesh's arrays, whose addresses never change. May wait. Returns false if they cannot be loaded.
  /// Any thread, one at a time for each mesh.
  virtual bool load() noexcept = 0;
  /// Reports to the tracer that the loaded arrays are unusable, with the reason.
  virtual void fail(const char* why) noexcept = 0;
  /// Frees the memory of the arrays; they read as zeros until load().
  virtual void drop() noexcept = 0;
  /// Bytes of the arrays.
  virtual size_t bytes() const noexcept = 0;
  /// Bounds of the whole mesh for rays, object space.
  struct Whole {
    glm::vec3 lower{0}, upper{0};
    float longestEdge = 0;
  };
  /// The whole mesh, if this is its first page; otherwise null.
  virtual const Whole* whole() const noexcept = 0;
  /// Maximum bytes for the arrays and structures of all pages.
  virtual size_t budget() const noexcept = 0;
};

}  // namespace gluray::scene
