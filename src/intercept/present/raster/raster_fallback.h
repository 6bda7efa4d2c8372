// Draws a snapshot with the real OpenGL: what the program would have had, for when tracing fails after its
// draws were held back. GL thread, outside glBegin/glEnd.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/write_back/state_guard.h"
#include "scene/snapshot.h"

namespace gluray::present {

/// Draws every instance, into the framebuffer that is bound, with the target's depth function: those of fixed
/// function in order, then those of shader programs in order. No queryable state differs afterwards. False,
/// with nothing drawn, where the attribute stack is full or fixed function is missing and needed.
bool drawByRealGl(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                  const gl::PresentTarget& target);

/// What the depth of surfaces that were traced is drawn again with (depth_again.cpp).
struct DepthPass {
  GLuint program = 0, depth = 0;  // depth: a texture of the depth that is there
  bool multisampled = false;      // is the texture
  int sample = -1;                // the only one to be written; -1: all
};

/// The fixed-function instances alone. With `again`, depth alone. False, with nothing drawn, as above.
bool drawWithFixedFunction(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                           GLenum depthFunc, const DepthPass* again = nullptr);

}  // namespace gluray::present
