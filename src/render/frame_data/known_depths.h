// Shortens primary rays to the depths that the framebuffer already has (scene::SecondaryScene::framebuffer,
// docs/adr/0075). Any thread.
#pragma once
#include "accel/world.h"
#include "render/camera/ray_setup.h"
#include "scene/secondary_scene.h"

#include <optional>

namespace gluray::render {

/// Maps window depths to ray intervals. A ray reaches NDC depth z at t = k / (s (1 + k r)), where k = z + 1
/// is the way from the near plane, s RaySetup::directionScale and r the growth of w along the ray.
struct KnownDepths {
  const scene::FramebufferCapture* capture = nullptr;  // the snapshot's
  double depthNear = 0, perDepth = 0;                  // k = (window depth - depthNear) * perDepth
  double growth = 0, perScale = 0;                     // r, 1 / s
  float clear = 1;                                     // window depths from here on show no surface
  // Half width of the interval around the framebuffer's depth, in units of t: reach + steps / w^2 + rounding
  // * t, where w = 1 + k r.
  double reach = 0, steps = 0, rounding = 0;
};

/// Makes them for the snapshot's framebuffer and the primary rays `rays` in the snapshot's world. None if the
/// depths are unknown, if rays do not start at the near plane, or if the program's polygon offset moves
/// depths away from surfaces.
std::optional<KnownDepths> findKnownDepths(const scene::Snapshot&, const RaySetup& rays, const accel::World&);

}  // namespace gluray::render
