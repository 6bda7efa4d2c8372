// Builds shader programs of our own. GL thread, context current.
#pragma once
#include "gl/glsl/shader_texts.h"
#include "gl/real/real.h"

#include <GL/gl.h>

#include <functional>
#include <vector>

namespace gluray::gl {

/// Links a shader program of these shaders; `prepare` is called before, with its name. 0: it does not link.
GLuint buildProgram(const RealGl& real, const std::vector<ShaderTexts::Shader>& shaders,
                    const std::function<void(GLuint)>& prepare = {});

}  // namespace gluray::gl
