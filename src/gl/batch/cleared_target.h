// A framebuffer that holds nothing but what it was cleared to. Plain data, GL thread.
#pragma once
#include "scene/snapshot.h"

#include <GL/gl.h>

#include <array>

namespace gluray::gl {

/// What a framebuffer (0: the window) was last cleared to as a whole, depth to 1, nothing having been drawn
/// or sent into it since.
struct ClearedTarget {
  GLuint framebuffer = 0;
  scene::Region region;          // pixels
  std::array<float, 4> color{};  // as given to glClearColor
};

}  // namespace gluray::gl
