// Texture environment and coordinate generation of the active unit, read back from the real OpenGL. GL
// thread.
#pragma once
#include "gl/real/real.h"
#include "scene/texture.h"

namespace gluray::gl {

/// Reads environment mode, combiner and colour. False if one of them needs an extension that is not traced.
bool readEnvironment(const RealGl& real, scene::Texture& texture);

/// Reads coordinate generation. False if a mode needs an extension that is not traced.
bool readTexGen(const RealGl& real, scene::TexGen& gen);

/// Bit mask of the other texture units whose texels the combiner reads.
uint32_t otherUnits(const scene::Texture& texture);

/// Whether the texture environments preserve alpha 1.
bool keepOpaque(const std::vector<scene::Texture>& textures);

}  // namespace gluray::gl
