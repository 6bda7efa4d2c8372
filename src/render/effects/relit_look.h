// Shades hits by the surface's own lighting equation with the visibility of each light and with dome light.
// Tracing threads.
#pragma once
#include "render/effects/shadow_lights.h"
#include "render/integrators/light_visibility.h"
#include "render/integrators/metric.h"

namespace gluray::render {

/// Lights that settings add to a surface's shading. The diffuse light of area lights is an integral.
struct AreaLights {
  const Metric& metric;
  const std::vector<scene::LightSource>& sources;
  size_t first;  // the shading's light that is sources[0]
};

/// Incident light at hits on one instance.
struct Arrival {
  const ShadowLights::Rows& rows;
  const Visibility& visibility;
  const scene::Dome* dome;            // null: none shines on the surface
  const AreaLights* areas = nullptr;  // null: no light has an area
};

/// Shades the hits on `surface` by the local look with this incident light.
void shadeAgain(const FrameData&, const Surface& surface, const ColoredHits&, const Arrival&, ColorRows&);
/// Computes the fog's contribution to the hits' colours, as on black surfaces. For surfaces with fog.
void fogAlone(const ColoredHits&, ColorRows&);

}  // namespace gluray::render
