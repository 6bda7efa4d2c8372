// The texts of a shader program's shaders. GL thread, context current.
#pragma once
#include "gl/real/real.h"

#include <GL/gl.h>

#include <memory>
#include <string>
#include <vector>

namespace gluray::gl {

struct ShaderTexts {
  struct Shader {
    GLenum type = 0;
    std::string text;
  };
  std::vector<Shader> shaders;
  bool all = false;  // whether `shaders` has the texts of all attached shaders
};

/// The texts of the shaders that are attached now. Host programs may detach shaders as soon as they are
/// linked.
std::shared_ptr<const ShaderTexts> readShaderTexts(const RealGl& real, GLuint program);

}  // namespace gluray::gl
