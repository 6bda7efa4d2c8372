#include "gl/glsl/shader_texts.h"

#include <GL/glext.h>

#include <algorithm>
#include <utility>

namespace gluray::gl {
namespace {

constexpr GLsizei kShaders = 32;  // a stage may have several; `all` is false for programs with more

/// False if the shader has no text or not all of it could be read.
bool readShader(const RealGl& real, GLuint name, ShaderTexts& texts) {
  GLint type = 0, length = 0;  // length includes the terminating 0
  real.GetShaderiv(name, GL_SHADER_TYPE, &type);
  real.GetShaderiv(name, GL_SHADER_SOURCE_LENGTH, &length);
  if (length <= 0) return false;
  GLsizei written = 0;
  std::string text(static_cast<size_t>(length), '\0');
  real.GetShaderSource(name, length, &written, text.data());
  text.resize(static_cast<size_t>(std::clamp(written, 0, length - 1)));
  texts.shaders.push_back({static_cast<GLenum>(type), std::move(text)});
  return written == length - 1;  // else another thread has changed the text
}

}  // namespace

std::shared_ptr<const ShaderTexts> readShaderTexts(const RealGl& real, GLuint program) {
  auto texts = std::make_shared<ShaderTexts>();
  GLuint shaders[kShaders] = {};
  GLint attached = 0;
  GLsizei count = 0;
  real.GetProgramiv(program, GL_ATTACHED_SHADERS, &attached);
  real.GetAttachedShaders(program, kShaders, &count, shaders);
  count = std::clamp(count, 0, kShaders);
  texts->all = count == attached;
  for (GLsizei i = 0; i < count; ++i) texts->all = readShader(real, shaders[i], *texts) && texts->all;
  return texts;
}

}  // namespace gluray::gl
