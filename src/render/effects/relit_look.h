// The local look with what arrives of each light: the surface's own equation, where its lights are shadowed
// and light comes from all sides. Tracing threads.
#pragma once
#include "render/effects/shadow_lights.h"
#include "render/integrators/factors.h"
#include "render/integrators/metric.h"

namespace gluray::render {

/// Lights of a surface's shading that settings add; of those with an area the diffuse light is an integral.
struct AreaLights {
  const Metric& metric;
  const std::vector<scene::LightSource>& sources;
  size_t first;  // the shading's light that is sources[0]
};

/// What arrives at hits on one instance.
struct Arrival {
  const ShadowLights::Rows& rows;
  const Factors& factors;
  const scene::Dome* dome;            // null: none shines on the surface
  const AreaLights* areas = nullptr;  // null: no light has an area
};

/// Shades the hits as the local look does, on `surface`, with what arrives of its lights.
void shadeAgain(const FrameData&, const Surface& surface, const ColoredHits&, const Arrival&, ColorRows&);
/// What fog adds to the hits' colours: those of black surfaces. For surfaces with fog.
void fogAlone(const ColoredHits&, ColorRows&);

}  // namespace gluray::render
