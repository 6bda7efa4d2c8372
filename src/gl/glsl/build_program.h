// Builds GLuRay's own shader programs. GL thread, context current.
#pragma once
#include "gl/glsl/shader_texts.h"
#include "gl/real/real.h"

#include <GL/gl.h>

#include <functional>
#include <vector>

namespace gluray::gl {

/// Links a shader program of these shaders and returns its name; 0 if it does not link. Calls `prepare` with
/// the name before it links.
GLuint buildProgram(const RealGl& real, const std::vector<ShaderTexts::Shader>& shaders,
                    const std::function<void(GLuint)>& prepare = {});

}  // namespace gluray::gl
