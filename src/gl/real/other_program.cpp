#include "gl/real/other_program.h"

#include "gl/real/extensions.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <string_view>

namespace gluray::gl {
namespace {

constexpr std::array<GLenum, 6> kShaderTypes{GL_VERTEX_SHADER,          GL_FRAGMENT_SHADER,
                                             GL_GEOMETRY_SHADER,        GL_TESS_CONTROL_SHADER,
                                             GL_TESS_EVALUATION_SHADER, GL_COMPUTE_SHADER};

bool has(const RealGl& real, int version, int since, std::string_view extension) {
  return version >= since || hasExtension(real, version, extension);
}

bool hasPipelines(const RealGl& real, int version) {
  return isPresent(real.ActiveShaderProgram) && has(real, version, 41, "GL_ARB_separate_shader_objects");
}

GLint valueOf(const RealGl& real, GLuint program, GLenum name) {
  GLint value = 0;
  real.GetProgramiv(program, name, &value);
  return value;
}

}  // namespace

OtherProgram::OtherProgram(const RealGl& real)
    : real_(real), program_(static_cast<GLuint>(integer(real, GL_CURRENT_PROGRAM))), inUse_(program_) {
  const int version = versionOf(real);
  if (program_ == 0) pipeline_ = programPipeline(real, hasPipelines(real, version));
  if (program_ == 0 && pipeline_ == 0) return;
  readSubroutines(version);
  if (program_ != 0) keepAlive(version);
}

OtherProgram::~OtherProgram() {
  const bool changed = inUse_ != program_ || unbound_;
  if (inUse_ != program_) real_.UseProgram(program_);
  if (unbound_) real_.BindProgramPipeline(pipeline_);
  if (holder_ != 0) real_.DeleteProgramPipelines(1, &holder_);
  for (size_t stage = 0; stage < kStages && changed; ++stage)
    if (const std::vector<GLuint>& values = subroutines_[stage]; !values.empty())
      real_.UniformSubroutinesuiv(kShaderTypes[stage], static_cast<GLsizei>(values.size()), values.data());
}

void OtherProgram::use(GLuint program) {
  if (program == 0 && pipeline_ != 0 && !unbound_) {
    unbound_ = true;
    real_.BindProgramPipeline(0);
  }
  if (program == inUse_) return;
  inUse_ = program;
  real_.UseProgram(program);
}

GLuint OtherProgram::ofStage(size_t stage) const {
  if (program_ != 0) return program_;
  GLint program = 0;
  real_.GetProgramPipelineiv(pipeline_, kShaderTypes[stage], &program);
  return static_cast<GLuint>(program);
}

void OtherProgram::readSubroutines(int version) {
  if (!isPresent(real_.GetProgramStageiv) || !has(real_, version, 40, "GL_ARB_shader_subroutine")) return;
  const size_t stages = version >= 43 ? kStages : kStages - 1;  // without compute shaders
  for (size_t stage = 0; stage < stages; ++stage) {
    const GLuint program = ofStage(stage);
    GLint uniforms = 0, locations = 0;
    const auto ask = [&](GLenum name, GLint& value) {
      real_.GetProgramStageiv(program, kShaderTypes[stage], name, &value);
    };
    if (program != 0) ask(GL_ACTIVE_SUBROUTINE_UNIFORMS, uniforms);
    // Mesa (22.3) refuses this for stages that the program does not have.
    if (uniforms > 0) ask(GL_ACTIVE_SUBROUTINE_UNIFORM_LOCATIONS, locations);
    subroutines_[stage].resize(static_cast<size_t>(locations));
    for (GLint location = 0; location < locations; ++location)
      real_.GetUniformSubroutineuiv(kShaderTypes[stage], location,
                                    &subroutines_[stage][static_cast<size_t>(location)]);
  }
}

/// A program pipeline object keeps a deleted program alive while it is the pipeline's active program.
void OtherProgram::keepAlive(int version) {
  if (valueOf(real_, program_, GL_DELETE_STATUS) == 0 || !hasPipelines(real_, version)) return;
  if (valueOf(real_, program_, GL_LINK_STATUS) == 0) return;  // its last link failed: it cannot be activated
  real_.GenProgramPipelines(1, &holder_);
  real_.ActiveShaderProgram(holder_, program_);
}

}  // namespace gluray::gl
