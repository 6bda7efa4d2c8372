// The local look with what arrives of each light: the surface's own equation, where its lights are shadowed
// and light comes from all sides. Tracing threads.
#pragma once
#include "render/integrators/factors.h"
#include "render/lights/shadow_lights.h"

namespace gluray::render {

/// What arrives at hits on one instance.
struct Arrival {
  const ShadowLights::Rows& rows;
  const Factors& factors;
  const scene::Dome* dome;  // null: none shines on the surface
};

/// Shades the hits as the local look does, on `surface`, with what arrives of its lights.
void shadeAgain(const FrameData&, const Surface& surface, const ColoredHits&, const Arrival&, ColorRows&);

}  // namespace gluray::render
