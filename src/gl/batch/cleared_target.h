// A framebuffer that contains nothing but a clear. Plain data, GL thread.
#pragma once
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <array>

namespace gluray::gl {

/// The last clear of a framebuffer (0: the window): its colour, and depth 1. Since then nothing was drawn or
/// copied into `region`.
struct ClearedTarget {
  GLuint framebuffer = 0;
  scene::Region region;          // pixels
  std::array<float, 4> color{};  // as given to glClearColor
};

}  // namespace gluray::gl
