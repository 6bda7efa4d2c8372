// A framebuffer that holds nothing but a clear. Plain data, GL thread.
#pragma once
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <array>

namespace gluray::gl {

/// The last clear of a framebuffer (0: the window): colour, and depth to 1. Nothing was drawn or copied into
/// `region` since.
struct ClearedTarget {
  GLuint framebuffer = 0;
  scene::Region region;          // pixels
  std::array<float, 4> color{};  // as given to glClearColor
};

}  // namespace gluray::gl
