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

/// Whether the triangle of `a` was drawn after that of `b`.
inline bool isDrawnLater(const scene::Snapshot& s, const Nearest& a, const Nearest& b) {
  const scene::Instance &of = s.instances[a.instance], &ofOther = s.instances[b.instance];
  if (of.order != ofOther.order) return of.order > ofOther.order;
  const auto number = [](const scene::Instance& i, uint32_t primitive) {
    return reinterpret_cast<const uint32_t*>(i.mesh->triangleNumbers.data)[primitive];
  };
  if (of.mesh->residence && ofOther.mesh->residence)  // pages of one mesh, in an order of their own
    return number(of, a.primitive) > number(ofOther, b.primitive);
  return std::tie(a.instance, a.primitive) > std::tie(b.instance, b.primitive);
}

/// Whether OpenGL's depth test prefers `next` to `best`. If the depth buffer rounds both depths to one step,
/// the order of drawing decides. A strict order of all triangles, whatever they are compared in turn.
inline bool isSeenBefore(const scene::Snapshot& s, const Nearest& next, const Nearest& best) {
  if (best.instance == accel::kNoHit) return true;
  const double depth = std::clamp(next.depth, 0.0, 1.0), bestDepth = std::clamp(best.depth, 0.0, 1.0);
  const double step = s.depthSteps > 0 ? 1 / s.depthSteps : double{s.polygonOffset.resolution};
  if (std::abs(depth - bestDepth) > step) return (depth < bestDepth) != s.camera.largestWins;
  const double steps = std::round(depth / step), bestSteps = std::round(bestDepth / step);
  if (steps != bestSteps) return (steps < bestSteps) != s.camera.largestWins;
  return isDrawnLater(s, next, best) == s.laterWins;
}

}  // namespace gluray::render
