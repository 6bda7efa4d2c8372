// Random fixed-function scenes of valid calls, as programs draw them. Each seed gives one scene.
#pragma once
#include "tests/fuzz/scenes/script.h"

#include <cstdint>
#include <vector>

namespace gluray::fuzz {

inline constexpr int kSceneSize = 96;  // width and height of the framebuffer, pixels

/// The scene of `seed`: calls for a fresh context. `lists`: with display lists, after which current values
/// sometimes differ from the real OpenGL's (avoided.md).
std::vector<Call> makeScene(uint64_t seed, bool lists = false);

/// Makes the calls; `answers` receives queried current values, materials and errors.
void playScene(Gl gl, const std::vector<Call>& calls, Answers& answers);

}  // namespace gluray::fuzz
