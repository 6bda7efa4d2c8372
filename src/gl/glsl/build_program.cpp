#include "gl/glsl/build_program.h"

#include <GL/glext.h>

namespace gluray::gl {

GLuint buildProgram(const RealGl& real, const std::vector<ShaderTexts::Shader>& shaders,
                    const std::function<void(GLuint)>& prepare) {
  const GLuint program = real.CreateProgram();
  if (program == 0) return 0;
  for (const ShaderTexts::Shader& each : shaders) {
    const GLuint shader = real.CreateShader(each.type);
    const char* const text = each.text.c_str();
    real.ShaderSource(shader, 1, &text, nullptr);
    real.CompileShader(shader);
    real.AttachShader(program, shader);
    real.DeleteShader(shader);
  }
  if (prepare) prepare(program);
  real.LinkProgram(program);
  GLint linked = GL_FALSE;
  real.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return program;
  real.DeleteProgram(program);
  return 0;
}

}  // namespace gluray::gl
