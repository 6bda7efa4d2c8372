// Random fixed-function scenes of valid calls, as programs draw them. Each seed gives one scene.
#pragma once
#include "gl/real/real.h"

#include <cstdint>
#include <vector>

namespace gluray::fuzz {

inline constexpr int kSceneSize = 96;  // width and height of the framebuffer, pixels

/// Draws the scene of `seed`; `answers` receives queried current values, materials and errors.
void drawScene(const gl::RealGl& gl, uint64_t seed, std::vector<float>& answers);

}  // namespace gluray::fuzz
