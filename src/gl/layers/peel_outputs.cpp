#include "gl/layers/peel_outputs.h"

#include "gl/programs/uniforms.h"
#include "gl/real/state_queries.h"
#include "gl/state/output_state.h"

#include <GL/glext.h>

namespace gluray::gl {

constexpr GLuint kMaxOutputs = 8;

std::vector<HeldPass::Output> outputsOf(ShadowState& shadow) {
  const RealGl& real = shadow.real;
  std::vector<HeldPass::Output> outputs;
  for (GLuint i = 0; i < kMaxOutputs; ++i) {
    const auto buffer = static_cast<GLenum>(integer(real, GL_DRAW_BUFFER0 + i));
    outputs.emplace_back();
    if (buffer == GL_NONE) continue;
    const auto ask = [&](GLenum name) { return attachmentValue(real, GL_DRAW_FRAMEBUFFER, buffer, name); };
    if (ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE) != GL_TEXTURE ||
        shadow.images.mayBeDeleted(real, GL_DRAW_FRAMEBUFFER, buffer))
      return {};
    outputs.back() = {static_cast<GLuint>(ask(GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME)),
                      ask(GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL)};
  }
  while (!outputs.empty() && outputs.back().texture == 0) outputs.pop_back();
  return outputs;
}

GLuint outputOf(const RealGl& real, const KnownProgram& known, const std::vector<HeldPass::Output>& outputs) {
  const GLint location = real.GetFragDataLocation(known.program.name, known.family->passOutput.c_str());
  if (location < 0 || static_cast<size_t>(location) >= outputs.size()) return 0;
  const HeldPass::Output& output = outputs[static_cast<size_t>(location)];
  return output.level == 0 ? output.texture : 0;
}

GLint inputUnit(const ProgramState& program) {
  const ProgramUniform* sampler = program.known->program.uniform(program.known->family->passInput);
  if (!sampler || sampler->type != GL_SAMPLER_2D || !program.uniforms) return -1;
  return (*program.uniforms)[sampler->first].integers[0];
}

GLuint inputTexture(const RealGl& real, const ProgramState& program) {
  const GLint unit = inputUnit(program);
  if (unit < 0) return 0;
  const GLint active = integer(real, GL_ACTIVE_TEXTURE);
  real.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  const GLint name = integer(real, GL_TEXTURE_BINDING_2D);
  real.ActiveTexture(static_cast<GLenum>(active));
  return static_cast<GLuint>(name);
}

bool peelsIntoAll(ShadowState& shadow) {
  const bool open = !shadow.viewport().scissorTest || shadow.viewport().scissor == shadow.viewport().box;
  return open && shadow.target().framebuffer != 0 && shadow.target().samples == 1 &&
         shadow.viewport().box.x == 0 && shadow.viewport().box.y == 0 && shadow.viewport().box.z > 0 &&
         shadow.viewport().box.w > 0 && keepsLargest(shadow.real, shadow.rare());
}

}  // namespace gluray::gl
