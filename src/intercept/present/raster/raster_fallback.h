// Draws a snapshot with the real OpenGL, if tracing fails after draws were held back. GL thread, outside
// glBegin/glEnd.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/state/state_guard.h"
#include "scene/snapshot.h"

namespace gluray::present {

/// Draws every instance into the bound framebuffer with the target's depth function: first those of fixed
/// function in order, then those of shader programs in order. Restores all queryable state. False, with
/// nothing drawn, if the attribute stack is full, or fixed function is needed but missing.
bool drawByRealGl(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                  const gl::PresentTarget& target);

/// Parameters for redrawing the depth of traced surfaces (depth_redraw.cpp).
struct DepthPass {
  GLuint program = 0, depth = 0;  // depth: a texture of the existing depth
  bool multisampled = false;      // the texture is
  int sample = -1;                // the only sample to write; -1: all
};

/// Draws only the fixed-function instances; with `again`, only the depth of all instances. False as above.
bool drawWithFixedFunction(const gl::RealGl& real, const Features& features, const scene::Snapshot& snapshot,
                           GLenum depthFunc, const DepthPass* again = nullptr);

}  // namespace gluray::present
