// Clusters: a few neighbouring primitives of a draw with a bounding box, in groups with boxes of their own.
// Finds the clusters that may be visible in front of a depth image. Loops run in the shared arena. Any
// thread, one at a time for each object.
#pragma once
#include "gl/culled/clusters/box_visibility.h"
#include "gl/culled/clusters/depth_pyramid.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gluray::gl {

/// The primitives of a draw: separate triangles, or `corners` vertices each.
struct Primitives {
  const std::byte* positions = nullptr;  // of vertex `lowest`: `components` (2, 3 or 4) floats or doubles
  uint32_t lowest = 0;
  size_t stride = 0;   // bytes between vertices
  int components = 3;  // a missing fourth one is 1
  bool doubles = false;
  const uint32_t* indices = nullptr;  // null: vertices in order from `first`
  uint32_t first = 0;
  uint32_t count = 0;  // primitives
  uint32_t corners = 3;

  uint32_t vertex(uint32_t primitive, uint32_t corner) const {
    const size_t at = size_t{primitive} * corners + corner;
    return indices ? indices[at] : first + static_cast<uint32_t>(at);
  }
  glm::dvec4 position(uint32_t vertex) const;
};

class Clusters {
 public:
  static constexpr uint32_t kPrimitives = 8;  // in each cluster but the last
  static constexpr size_t kGroup = 8;         // clusters in a group, and groups in a large group

  /// Throws std::bad_alloc.
  explicit Clusters(const Primitives& primitives);
  /// Updates the boxes for moved vertices of the same primitives.
  void refit(const Primitives& primitives) { findBoxes(primitives); }

  uint32_t count() const { return static_cast<uint32_t>(boxes_.size()); }
  /// Words of a set of clusters.
  size_t words() const { return (boxes_.size() + 63) / 64; }
  size_t bytes() const {
    return (boxes_.size() + groups_.size() + largeGroups_.size()) * sizeof(Box) +
           numbers_.size() * sizeof(uint32_t);
  }
  /// Whether clusters are consecutive primitives of the draw; otherwise they are spatial neighbours.
  bool areRuns() const { return numbers_.empty(); }

  /// Sets bit i of `visible` if cluster i may have a pixel at or in front of the pyramid's depth.
  /// Conservative, like BoxVisibility. Null pyramid: everything in the view.
  void mayShow(const ClipMatrix& matrix, const WindowMapping& window, const DepthPyramid* pyramid,
               std::vector<uint64_t>& visible) const;
  /// Sets the bits of all clusters.
  void all(std::vector<uint64_t>& visible) const;
  /// Whether any cluster may be visible.
  bool anyMayShow(const BoxVisibility& view) const;

  /// Writes the vertex numbers of the primitives of all clusters in `visible`, in the order of the draw.
  /// `out` has room for them. Returns how many were written.
  size_t write(std::span<const uint64_t> visible, const Primitives& primitives, uint32_t* out) const;
  /// Primitives of the clusters in `visible`.
  uint64_t primitivesIn(std::span<const uint64_t> visible) const;

 private:
  struct Box {
    glm::vec4 center{0}, extent{0};  // extent.x < 0: positions are not finite, always visible
    bool isFinite() const { return extent.x >= 0; }
  };
  using Boxes = std::vector<Box>;
  static Box boxAround(const glm::dvec4& lower, const glm::dvec4& upper);
  static Box groupOf(const Boxes& boxes, size_t first, size_t last);
  static void group(const Boxes& boxes, Boxes& groups);
  uint32_t primitivesOf(uint32_t cluster) const;
  uint32_t primitiveAt(uint32_t cluster, uint32_t i) const {
    const uint32_t at = cluster * kPrimitives + i;
    return numbers_.empty() ? at : numbers_[at];
  }
  void findBoxes(const Primitives& primitives);
  bool areScattered(const Primitives& primitives) const;
  void sort(const Primitives& primitives);

  uint32_t primitives_ = 0;
  std::vector<uint32_t> numbers_;  // primitives, cluster by cluster; empty: in draw order
  Boxes boxes_, groups_, largeGroups_;
  Box all_;
};

}  // namespace gluray::gl
