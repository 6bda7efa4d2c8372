// The geometry of a draw that is culled: its clusters, built in the background. A part of CulledDraws, GL
// thread.
#pragma once
#include "base/background_job.h"
#include "gl/arrays/arrays.h"
#include "gl/arrays/assembly.h"
#include "gl/buffers/buffer.h"
#include "gl/culled/clusters/clusters.h"
#include "gl/culled/clusters/unit_clusters.h"
#include "gl/real/real.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace gluray::gl {

class CulledMesh {
 public:
  /// `positions`: the array of positions, with `components` relevant components. Null if positions cannot be
  /// read.
  static std::shared_ptr<CulledMesh> create(const RealGl& real, const ArraySource& positions, int components,
                                            const ArrayState& arrays, const Assembly& assembly,
                                            const Elements& elements);

  /// Makes a mesh whose positions takePositions() sets: clip coordinates.
  static std::shared_ptr<CulledMesh> withoutPositions(const RealGl& real, const ArrayState& arrays,
                                                      const Assembly& assembly, const Elements& elements);
  /// The first vertex that the primitives use, and one past the last.
  uint32_t firstVertex() const { return primitives_.lowest; }
  uint32_t endVertex() const { return end_; }
  /// Copies the positions of all vertices, four floats each, for build().
  void takePositions(const std::byte* positions);
  /// Updates the clusters for new positions. GL thread, after build().
  void refit(const std::byte* positions);
  /// Updates the clusters of `units` units of instances, whose positions are `step` bytes apart.
  void refit(const std::byte* positions, size_t step, uint32_t units);
  /// Clusters of the units, after refit().
  const UnitClusters& units() const { return units_; }

  /// Builds the clusters. Any thread, once.
  void build();
  /// Frees the positions, which are unused once the clusters are built. GL thread.
  void forgetPositions() { positionStorage_.reset(), copied_ = {}; }
  /// Frees all but the boxes, for meshes that are neither written nor refitted later.
  void forgetVertices() {
    forgetPositions();
    indexStorage_.reset(), numbers_ = {}, primitives_.indices = nullptr;
  }
  bool isBuilt() const { return clusters_.has_value(); }
  const Clusters& clusters() const { return *clusters_; }
  uint32_t primitives() const { return primitives_.count; }
  uint32_t corners() const { return primitives_.corners; }
  GLenum mode() const { return primitives_.corners == 4 ? GL_QUADS : GL_TRIANGLES; }
  /// Vertex numbers of the primitives of clusters, in the order of the draw.
  size_t write(std::span<const uint64_t> clusters, uint32_t* out) const {
    return clusters_->write(clusters, primitives_, out);
  }

 private:
  CulledMesh() = default;
  /// Returns false if the draw reads beyond the index buffer.
  bool readIndices(const RealGl& real, const ArrayState& arrays, const Assembly& assembly,
                   const Elements& elements);
  void findVertices();
  void copyPositions(uint32_t end);

  std::shared_ptr<const BufferStorage> positionStorage_, indexStorage_;
  std::vector<uint32_t> numbers_;
  uint32_t end_ = 0;               // one past the last vertex
  std::vector<std::byte> copied_;  // positions in the program's memory, until the clusters are built
  Primitives primitives_;
  std::optional<Clusters> clusters_;
  UnitClusters units_;
};

}  // namespace gluray::gl
