// Interpolates colours from scattered points by a pyramid of cells. Read by every tracing thread.
#pragma once
#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace gluray::render {

/// Each level has cells of twice the size of the one before, with the sum of all colours in them. A point
/// gets the interpolated mean of the finest cells around it that contain enough points, supplemented by
/// coarser cells (push and pull, Gortler and others 1996, "The Lumigraph").
class SpaceColors {
 public:
  /// Prepares for about `points` points within the box.
  void prepare(const glm::vec3& lower, const glm::vec3& upper, size_t points);
  /// Adds a point after prepare(). Points outside the box are clamped to it.
  void add(const glm::vec3& point, const glm::vec3& color);
  /// Call after the last point.
  void finish();
  /// Whether it has no colours.
  bool empty() const { return levels_.empty(); }
  /// Must not be empty().
  glm::vec3 at(const glm::vec3& point) const;

 private:
  struct Level {
    glm::ivec3 size{1};
    std::vector<glm::vec4> cells;  // sum of colours; w: their number
    float enough = 1;              // number of points from which no coarser cells are needed
    glm::vec4& cell(const glm::ivec3& at) { return cells[index(at)]; }
    size_t index(const glm::ivec3& at) const {
      return (static_cast<size_t>(at.z) * static_cast<size_t>(size.y) + static_cast<size_t>(at.y)) *
                 static_cast<size_t>(size.x) +
             static_cast<size_t>(at.x);
    }
    glm::vec4 interpolated(const glm::vec3& at) const;
    float halfOfMean() const;
  };

  glm::vec3 lower_{0};
  float cellsOfUnit_ = 0;      // of the finest level
  std::vector<Level> levels_;  // the finest one first
};

}  // namespace gluray::render
