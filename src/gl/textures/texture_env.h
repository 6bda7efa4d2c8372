// Environment and coordinate generation of the active texture unit, read back from the real OpenGL. GL
// thread.
#pragma once
#include "gl/real.h"
#include "scene/texture.h"

namespace gluray::gl {

/// Environment mode, combiner, colour. False where they are of an extension that is not traced.
bool readEnvironment(const RealGl& real, scene::Texture& texture);

/// False where a mode is of an extension that is not traced.
bool readTexGen(const RealGl& real, scene::TexGen& gen);

/// Units whose texels the combiner reads besides its own, bit by bit.
uint32_t otherUnits(const scene::Texture& texture);

/// Whether the environments leave an opaque colour opaque.
bool keepOpaque(const std::vector<scene::Texture>& textures);

}  // namespace gluray::gl
