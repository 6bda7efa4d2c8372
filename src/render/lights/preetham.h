// The clear sky by day (A. Preetham, P. Shirley, B. Smits, "A Practical Analytic Model for Daylight", 1999).
// Any thread.
#pragma once
#include "render/lights/sky_image.h"

namespace gluray::render {

/// y is up. `sun`: any length; kept above the horizon. `turbidity`: 1.7 .. 10. The brightest of the sky's
/// luminance far from the sun is about 1; the sun's disc is as bright as makes it give a surface that faces
/// it about 1.5 times the sky's light. Below the horizon: `ground`.
SkyPicture preethamSky(const glm::vec3& sun, float turbidity, const glm::vec3& ground);

}  // namespace gluray::render
