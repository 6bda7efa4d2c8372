// Blend state, read back from the real OpenGL. GL thread.
#pragma once
#include "gl/real/real.h"
#include "scene/blending.h"

#include <optional>

namespace gluray::gl {

/// How fragments are blended into a framebuffer that has alpha. Empty if scene::Blending cannot express it,
/// as with factors that use a second source colour.
std::optional<scene::Blending> readBlending(const RealGl& real, bool writesDepth);

}  // namespace gluray::gl
