// Volumes as media that block light: their extinction on a lattice, and how much light passes along rays. Any
// thread.
#pragma once
#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace gluray::render {

/// Numbers at the middles of the equal cells of a box; x fastest.
struct Lattice {
  glm::ivec3 size{0};
  std::vector<float> values;
  float mean = 0;  // of the values, by those who made them
  size_t index(const glm::ivec3& cell) const {
    return (static_cast<size_t>(cell.z) * static_cast<size_t>(size.y) + static_cast<size_t>(cell.y)) *
               static_cast<size_t>(size.x) +
           static_cast<size_t>(cell.x);
  }
  /// Between the middles of cells, linear; beyond them, the nearest one's. `p`: in cells from the box's lower
  /// corner.
  float at(const glm::vec3& p) const;
};

/// A medium in the world of a snapshot.
struct PlacedLattice {
  std::shared_ptr<const Lattice> extinction;  // per unit of length in data space; 0 beyond the box
  glm::mat4 latticeFromWorld{1};              // to cells from the box's lower corner
  glm::mat3 dataFromWorld{1};                 // of directions

  /// The share of light that passes along origin + t * direction, t in 0 .. end, which may be infinite: exp(-
  /// the integral of the extinction), by the middles of parts that cross about one cell.
  float transmittance(const glm::vec3& origin, const glm::vec3& direction, float end) const;
};

/// Of all of them.
float transmittanceOf(const std::vector<PlacedLattice>& media, const glm::vec3& origin,
                      const glm::vec3& direction, float end);

}  // namespace gluray::render
