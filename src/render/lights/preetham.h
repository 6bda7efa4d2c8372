// Clear daytime sky (A. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight", 1999). Any
// thread.
#pragma once
#include "render/lights/sky_image.h"

namespace gluray::render {

/// y is up. `sun`: any length; kept above the horizon. `turbidity`: 1.7 .. 10. Away from the sun, the sky's
/// luminance is at most about 1. A surface that faces the sun gets about 1.5 times as much light from the
/// sun's disc as from the sky. Below the horizon: `ground`.
SkyPixels preethamSky(const glm::vec3& sun, float turbidity, const glm::vec3& ground);

}  // namespace gluray::render
