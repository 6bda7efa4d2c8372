// Matches surfaces of a frame with surfaces of the previous frame if their geometry has changed, as in a new
// time step, by their position in the drawing order. Any thread.
#pragma once
#include "base/hash.h"
#include "scene/mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

/// What is remembered of a surface.
struct ObjectTraits {
  Hash128 geometry;
  scene::Shape shape = scene::Shape::triangles;
  uint32_t triangles = 0;
  uint64_t look = 0;  // hash of its material and of which attributes its vertices have
};

/// How much a surface is like an earlier one: 0 (it cannot be the same) to 1.
double likeness(const ObjectTraits& earlier, const ObjectTraits& now);

inline constexpr size_t kNoObject = static_cast<size_t>(-1);

/// For each surface of `now` the index of the one of `before` that it is, or kNoObject. Keeps the order of
/// both. Lists of one length whose surfaces can be the same one by one are the same; of others the assignment
/// has the largest sum of likenesses, unless they are so long that they are compared one by one.
std::vector<size_t> alignObjects(const std::vector<const ObjectTraits*>& before,
                                 const std::vector<const ObjectTraits*>& now);

}  // namespace gluray::gl
