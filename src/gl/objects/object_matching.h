// Matches surfaces of a frame with surfaces of the previous frame by their position in the drawing order, if
// their geometry has changed, as in a new time step. Any thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

/// Properties of a surface that are remembered for the next frame.
struct ObjectTraits {
  Hash128 geometry;
  scene::Shape shape = scene::Shape::triangles;
  uint32_t triangles = 0;
  uint64_t look = 0;  // hash of its material and of the set of vertex attributes
};

/// Similarity of a surface and an earlier one, from 0 (cannot be the same) to 1.
double likeness(const ObjectTraits& earlier, const ObjectTraits& now);

inline constexpr size_t kNoObject = static_cast<size_t>(-1);

/// For each surface of `now`, the index of the matching surface of `before`, or kNoObject. Keeps the order of
/// both. If both lists have the same length and all pairs of equal index can match, these pairs match.
/// Otherwise the assignment has the largest sum of likenesses, unless the lists are too long to compare all
/// pairs.
std::vector<size_t> alignObjects(const std::vector<const ObjectTraits*>& before,
                                 const std::vector<const ObjectTraits*>& now);

}  // namespace gluray::gl
