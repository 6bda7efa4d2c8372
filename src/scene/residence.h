// Where the arrays of a mesh are while they are not in memory: a part of a scene larger than memory, a page,
// is loaded when a ray meets its bounds. Implemented by cluster/pages, called by accel/pages.
#pragma once
#include <glm/glm.hpp>

#include <cstddef>

namespace gluray::scene {

class Residence {
 public:
  virtual ~Residence() = default;
  /// Fills the mesh's arrays, whose places never change. May wait. False: they cannot be had. Any thread, one
  /// at a time for each mesh.
  virtual bool load() noexcept = 0;
  /// The loaded arrays are of no use: say why to whoever traces.
  virtual void fail(const char* why) noexcept = 0;
  /// Gives the memory of the arrays back; they read as zeros until load().
  virtual void drop() noexcept = 0;
  /// Bytes of the arrays.
  virtual size_t bytes() const noexcept = 0;
  /// Object space; bounds of what rays may hit.
  struct Whole {
    glm::vec3 lower{0}, upper{0};
    float longestEdge = 0;
  };
  /// Of the mesh that this is the first page of; null: it is a later page.
  virtual const Whole* whole() const noexcept = 0;
  /// Bytes that the arrays and structures of all such meshes may take.
  virtual size_t budget() const noexcept = 0;
};

}  // namespace gluray::scene
