// Texture images that the scenes share.
#pragma once
#include "scenes/scene.h"

#include <cstdint>
#include <vector>

namespace gluray::scenes {

inline constexpr Tolerance kTexelEdges{
    2, 0.003, 1e-5f, "borders of texels run through the centres of whole columns of pixels"};

/// RGBA8, width x height: coarse checkers with a gradient; the dark ones have alpha 90.
std::vector<uint8_t> pattern(int width, int height);
inline std::vector<uint8_t> pattern(int size) { return pattern(size, size); }

/// One filter, without mipmaps, and one wrap mode for the texture bound to `target`.
void sampling(Gl gl, GLenum target, GLint filter, GLint wrap);

/// A new texture, bound to `target`.
GLuint bindFresh(Gl gl, GLenum target);

/// pattern(size) into the texture bound to GL_TEXTURE_2D.
void upload(Gl gl, GLint internalFormat, int size, GLint filter, GLint wrap);

/// Every level of the texture bound to GL_TEXTURE_2D from size x size down to 1x1: checkers of two texels,
/// each level of another colour.
void tintedLevels(Gl gl, int size);

/// A square in the xy plane about (x, y) with (s, t) from (low, low) to (high, high).
void quad(Gl gl, float x, float y, float half, float low, float high);

/// A floor of 12 x 12 units that runs away from the viewer, with `repeats` texture repeats a unit.
void ground(Gl gl, float repeats);

}  // namespace gluray::scenes
