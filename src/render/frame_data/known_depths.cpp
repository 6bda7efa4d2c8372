#include "render/frame_data/known_depths.h"

#include <glm/glm.hpp>

#include <algorithm>

namespace gluray::render {

std::optional<KnownDepths> findKnownDepths(const scene::Snapshot& snapshot, const RaySetup& rays,
                                           const accel::World& world) {
  // Much more than depths are off.
  constexpr double kReach = 0.01;  // of the diagonal of the scene's bounds
  constexpr double kSteps = 64;    // of depth
  constexpr double kRounding = 1e-5;
  const auto& around = snapshot.secondaryScene;
  const scene::FramebufferCapture* capture = around ? around->framebuffer.get() : nullptr;
  if (!capture || !rays.linear.usable || !rays.clipPlanes.empty()) return {};
  if (snapshot.camera.largestWins || !(capture->depthNear < capture->depthFar) ||
      !(capture->offset == scene::PolygonOffset{}))
    return {};
  KnownDepths known;
  known.capture = capture;
  known.depthNear = double{capture->depthNear}, known.clear = capture->depthFar;
  known.perDepth = 2 / (double{capture->depthFar} - double{capture->depthNear});
  known.growth = rays.step.w / rays.start.w, known.perScale = 1 / rays.directionScale;
  known.reach = kReach * glm::length(glm::dvec3(world.upper() - world.lower()));
  const double resolution = std::max(double{snapshot.polygonOffset.resolution}, 0x1p-24);
  known.steps = kSteps * resolution * known.perDepth * known.perScale;
  known.rounding = kRounding;
  return known;
}

}  // namespace gluray::render
