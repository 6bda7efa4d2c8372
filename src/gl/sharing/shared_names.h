// Names of real objects that all contexts of a share group see.
#pragma once

#include <GL/gl.h>

#include <vector>

namespace gluray::gl {

struct SharedNames {
  std::vector<GLuint> lists, textures, programs;
};

}  // namespace gluray::gl
