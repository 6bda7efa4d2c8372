// Texture images read back from the real OpenGL. GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/real/extensions.h"
#include "gl/real/real.h"
#include "scene/texture.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <compare>
#include <memory>

namespace gluray::gl {

/// Whether level 0 of the texture bound to GL_TEXTURE_2D of the active unit is RGBA8 and has exactly this
/// size.
bool isRgba8(const RealGl& real, glm::ivec2 size);
/// Whether level 0 of that texture is RGBA8 and has at least this size.
bool holdsRgba8(const RealGl& real, glm::ivec2 size);

/// The part of a bound texture that is sampled, and how its texels are read.
struct ImageRange {
  GLint base = 0;      // level
  int levels = 0;      // from the base level on; 0: the texture is incomplete (GL 2.1, 3.8.10)
  bool decode = true;  // sRGB texels are decoded
  GLenum depthMode = GL_LUMINANCE;
  auto operator<=>(const ImageRange&) const = default;
};

/// The levels from which the texture bound to `target` of the active unit is sampled.
ImageRange rangeOf(const RealGl& real, const RareState& has, GLenum target, bool mipmapped);

/// Reads the levels of `range`. Null, with `reason` set, if they cannot be traced.
std::shared_ptr<const scene::TextureImage> readImage(const RealGl& real, const RareState& has, GLenum target,
                                                     const ImageRange& range, Reason& reason);

}  // namespace gluray::gl
