// Blending as the real OpenGL has it set. GL thread.
#pragma once
#include "gl/real.h"
#include "scene/blending.h"

#include <optional>

namespace gluray::gl {

/// What fragments do to a framebuffer that has alpha. Nothing where blending is of a kind that
/// scene::Blending does not know, such as factors of a second colour.
std::optional<scene::Blending> readBlending(const RealGl& real, bool writesDepth);

}  // namespace gluray::gl
