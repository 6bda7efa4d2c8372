// Random scenes of fixed function: what programs draw, not what they get wrong. A seed is a scene.
#pragma once
#include "gl/real.h"

#include <cstdint>
#include <vector>

namespace gluray::fuzz {

inline constexpr int kSceneSize = 96;  // width and height of the framebuffer, pixels

/// Draws the scene of `seed`; into `answers` go current values, materials and errors that were asked for.
void drawScene(const gl::RealGl& gl, uint64_t seed, std::vector<float>& answers);

}  // namespace gluray::fuzz
