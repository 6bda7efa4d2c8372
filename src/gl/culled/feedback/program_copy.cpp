#include "gl/culled/feedback/program_copy.h"

#include "gl/glsl/build_program.h"
#include "gl/glsl/glsl_tokens.h"
#include "gl/programs/set_uniform.h"

#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

namespace gluray::gl {
namespace {

/// Words in shader texts for which a copy would behave differently: own transform feedback, choices that are
/// not uniforms, and memory that is bound by other means.
bool isUnlikely(std::string_view word) {
  return word.starts_with("xfb_") || word == "subroutine" || word == "buffer" || word == "atomic_uint" ||
         word == "bindless_sampler" || word == "bindless_image";
}

bool canBeCopied(const ShaderTexts& texts) {
  if (!texts.all || texts.shaders.empty()) return false;
  for (const ShaderTexts::Shader& shader : texts.shaders) {
    if (shader.type != GL_VERTEX_SHADER && shader.type != GL_FRAGMENT_SHADER) return false;
    GlslTokens tokens(shader.text);
    for (std::string_view word = tokens.nextToken(); !word.empty(); word = tokens.nextToken())
      if (isUnlikely(word)) return false;
  }
  return true;
}

void drainErrors(const RealGl& real) {
  for (int i = 0; i < 16 && real.GetError() != GL_NO_ERROR; ++i) {}
}

}  // namespace

ProgramCopy::ProgramCopy(const RealGl& real, const Program& original) : original_(original) {
  const std::shared_ptr<const ShaderTexts> texts =
      original.texts ? original.texts : readShaderTexts(real, original.name);
  if (!texts || !canBeCopied(*texts) || original.writes) return;
  const bool linked = link(real, *texts) && findUniforms(real);
  if (linked) findBlocks(real);
  if (!linked) release(real);
  drainErrors(real);
}

bool ProgramCopy::link(const RealGl& real, const ShaderTexts& texts) {
  name_ = buildProgram(real, texts.shaders, [&](GLuint program) {
    for (const auto& [name, attribute] : original_.attributes)
      if (attribute.location >= 0 && !name.starts_with("gl_"))
        real.BindAttribLocation(program, static_cast<GLuint>(attribute.location), name.c_str());
    const char* const position = "gl_Position";
    real.TransformFeedbackVaryings(program, 1, &position, GL_INTERLEAVED_ATTRIBS);
  });
  return name_ != 0;
}

bool ProgramCopy::findUniforms(const RealGl& real) {
  const Program copy = reflect(real, name_);
  for (const auto& [name, uniform] : copy.uniforms) {
    if (uniform.block >= 0 || uniform.location < 0 || name.starts_with("gl_")) continue;
    const auto original = original_.uniforms.find(name);
    if (original == original_.uniforms.end() || original->second.type != uniform.type ||
        original->second.count < uniform.count || !isSettable(uniform.type))
      return false;
    for (GLint i = 0; i < uniform.count; ++i)
      elements_.push_back({original->second.first + static_cast<size_t>(i),
                           i == 0 ? uniform.location : uniform.more[static_cast<size_t>(i - 1)]});
  }
  return std::ranges::all_of(copy.attributes, [&](const auto& entry) {
    const auto original = original_.attributes.find(entry.first);
    return original != original_.attributes.end() && original->second.location == entry.second.location;
  });
}

void ProgramCopy::findBlocks(const RealGl& real) {
  GLint count = 0;
  if (isPresent(real.GetUniformBlockIndex)) real.GetProgramiv(name_, GL_ACTIVE_UNIFORM_BLOCKS, &count);
  for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
    std::array<GLchar, 1024> block{};
    real.GetActiveUniformBlockName(name_, i, block.size(), nullptr, block.data());
    const GLuint index = real.GetUniformBlockIndex(original_.name, block.data());
    if (index != GL_INVALID_INDEX) blocks_.emplace_back(index, i);
  }
}

void ProgramCopy::copyUniforms(const RealGl& real) const {
  const UniformValuesPtr values = readUniforms(real, original_);
  for (const Element& element : elements_) {
    UniformValue value = (*values)[element.from];
    value.location = element.location;
    setUniform(real, value);
  }
  for (const auto& [from, to] : blocks_) {
    GLint binding = 0;
    real.GetActiveUniformBlockiv(original_.name, from, GL_UNIFORM_BLOCK_BINDING, &binding);
    real.UniformBlockBinding(name_, to, static_cast<GLuint>(binding));
  }
}

void ProgramCopy::release(const RealGl& real) {
  if (name_ != 0) real.DeleteProgram(name_);
  name_ = 0;
}

}  // namespace gluray::gl
