// The textures that draws change. GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <vector>

namespace gluray::gl {

/// Names of the textures that are attached to the draw framebuffer.
std::vector<GLuint> texturesDrawnTo(const RealGl& real);

}  // namespace gluray::gl
