// The order of surfaces at a pixel.
#pragma once
#include "accel/rays/ray_packet.h"
#include "scene/snapshot.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace gluray::render {

/// The nearest triangle at a pixel so far.
struct Nearest {
  double depth = HUGE_VAL;  // window, not clamped
  uint32_t instance = accel::kNoHit, primitive = 0;
};

/// Whether OpenGL's depth test prefers `next` to `best`. If the depth buffer rounds both depths to one step,
/// the order of drawing decides. A strict order of all triangles, whatever they are compared in turn.
inline bool isSeenBefore(const scene::Snapshot& s, const Nearest& next, const Nearest& best) {
  if (best.instance == accel::kNoHit) return true;
  const double depth = std::clamp(next.depth, 0.0, 1.0), bestDepth = std::clamp(best.depth, 0.0, 1.0);
  const double step = s.polygonOffset.resolution;
  if (std::abs(depth - bestDepth) > step) return (depth < bestDepth) != s.camera.largestWins;
  const double steps = std::round(depth / step), bestSteps = std::round(bestDepth / step);
  if (steps != bestSteps) return (steps < bestSteps) != s.camera.largestWins;
  const bool later = std::tie(next.instance, next.primitive) > std::tie(best.instance, best.primitive);
  return later == s.laterWins;
}

}  // namespace gluray::render
