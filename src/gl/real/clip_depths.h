// Clip space whose depths range from 0 to 1 (glClipControl). Scenes know the usual range from -1 to 1. GL
// thread.
#pragma once
#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>
#include <glm/glm.hpp>

namespace gluray::gl {

/// Whether clip depths range from 0 to 1 now.
inline bool hasDepthsFromZero(const RealGl& real, const RareState& has) {
  return has.clipControl && integer(real, GL_CLIP_DEPTH_MODE) == GL_ZERO_TO_ONE;
}

/// The matrix `clip` followed by z = 2z - w, which maps depths from 0 .. 1 to -1 .. 1. Window depths stay the
/// same (GL 4.6, 13.8.1).
inline glm::dmat4 toUsualDepths(glm::dmat4 clip) {
  for (int c = 0; c < 4; ++c) clip[c].z = 2 * clip[c].z - clip[c].w;
  return clip;
}

/// The inverse of toUsualDepths(); exact for matrices of floats of similar size.
inline glm::dmat4 toDepthsFromZero(glm::dmat4 clip) {
  for (int c = 0; c < 4; ++c) clip[c].z = 0.5 * (clip[c].z + clip[c].w);
  return clip;
}

}  // namespace gluray::gl
