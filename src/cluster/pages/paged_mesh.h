// A mesh divided into pages, with the per-triangle arrays of its instance. Immutable; any thread.
#pragma once
#include "base/hash.h"
#include "cluster/pages/page_split.h"
#include "cluster/stream/page_layout.h"
#include "cluster/stream/shared_arrays.h"
#include "scene/snapshot.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::cluster {

class PagedMesh {
 public:
  /// Whether the instance's mesh can be divided into pages.
  static bool fits(const scene::Instance& instance, const scene::Shading& shading);
  /// Hash of the instance's arrays and all other inputs of its pages. `owner`: this rank.
  static Hash128 idOf(const scene::Instance& instance, uint32_t mostTriangles, int owner, ArrayNames& names);
  /// With the threads of the current arena. Throws std::bad_alloc.
  PagedMesh(const Hash128& id, const scene::Instance& instance, uint32_t mostTriangles, int owner);

  size_t count() const { return meshes_.size(); }
  Hash128 idOf(size_t page) const;
  /// The page as snapshots name it: its arrays have formats alone.
  const scene::MeshPtr& mesh(size_t page) const { return meshes_[page]; }
  /// Its arrays, as layOut() places them.
  std::vector<std::byte> content(size_t page) const;

 private:
  scene::MeshPtr named(size_t page, int owner) const;
  uint32_t mostMaterial() const;

  const Hash128 id_;
  const scene::MeshPtr mesh_;
  const TriangleArrays ofTriangles_;  // from the mesh's first triangle on
  const PageTable table_;
  uint32_t mostMaterial_ = 0;
  std::vector<scene::MeshPtr> meshes_;
};

}  // namespace gluray::cluster
