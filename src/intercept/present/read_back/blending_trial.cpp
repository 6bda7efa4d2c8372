#include "intercept/present/read_back/blending_trial.h"

#include "gl/real/state_queries.h"
#include "intercept/present/read_back/sample_copy.h"
#include "intercept/present/read_back/view_program.h"
#include "intercept/present/state/state_guard.h"

#include <GL/glext.h>

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace gluray::present {
namespace {

using gl::RealGl;

constexpr int kWidth = 512;  // two colours for each that a byte holds: itself, and the middle to the next one

/// A row each for alphas from gl::Opacity::kMin to infinity, and for those that need the number of a number
/// and a NaN.
constexpr const char* kRows = R"(#version 150
uniform float nan, zero;
out vec4 color;
void main() {
  float alphas[13] = float[13](1.0, 0.999, 0.9995, 1.0 - exp2(-20.0), 1.0 + exp2(-20.0), 3.0, 1e30, 1.0 / zero,
                               1.0 + max(nan, 0.0), 1.0 + max(0.0, nan), 2.0 - min(nan, 1.0),
                               2.0 - min(1.0, nan), 1.0 + clamp(nan, 0.0, 1.0));
  color = vec4(vec3(floor(gl_FragCoord.x) / 510.0), alphas[int(gl_FragCoord.y)]);
}
)";
constexpr int kHeight = 13;

using Pixels = std::vector<uint32_t>;

Pixels blended(const RealGl& real, const Features& has, float below) {
  const std::array<GLfloat, 4> color{below, below, below, below};
  real.ClearBufferfv(GL_COLOR, 0, color.data());
  drawAroundView(real, has.compatibility);
  Pixels pixels(size_t{kWidth} * kHeight);
  real.ReadPixels(0, 0, kWidth, kHeight, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

/// Draws over black and over white into a framebuffer of `format`.
bool replaces(const RealGl& real, const Features& has, GLenum format) {
  GLuint colors = 0;
  const GLint bound = gl::integer(real, GL_RENDERBUFFER_BINDING);
  real.GenRenderbuffers(1, &colors);
  real.BindRenderbuffer(GL_RENDERBUFFER, colors);
  real.RenderbufferStorage(GL_RENDERBUFFER, format, kWidth, kHeight);
  real.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound));
  bool same = false;
  {
    const CopyFramebuffer framebuffer(real);
    real.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colors);
    real.DrawBuffer(GL_COLOR_ATTACHMENT0);
    real.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer.name());
    if (real.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE)
      same = blended(real, has, 0) == blended(real, has, 1);
  }
  real.DeleteRenderbuffers(1, &colors);
  return takeErrors(real).empty() && same;
}

bool tried(const RealGl& real, const Features& has) {
  if (has.version < 32 || !has.readFramebuffers) return false;
  StateGuard guard(real, has);
  const GLuint program = buildViewProgram(real, has.compatibility, kRows);
  if (program == 0) return takeErrors(real), false;
  GLuint vertexArray = 0;
  if (!has.compatibility) real.GenVertexArrays(1, &vertexArray);
  bool passes = true;
  {
    StateGuard drawing(real, has);
    drawing.openFragmentPath();
    drawing.capability(GL_DEPTH_TEST, false);
    if (has.encoding) drawing.encoding(false);
    drawing.viewport(0, 0, kWidth, kHeight);
    drawing.scissorOff();
    drawing.plainPack();
    drawing.program(program);
    if (vertexArray != 0) drawing.vertexArray(vertexArray);
    real.Uniform1f(real.GetUniformLocation(program, "nan"), std::numeric_limits<float>::quiet_NaN());
    drawing.blendOver();
    for (const GLenum format : {GL_RGBA8, GL_RGB8}) passes = passes && replaces(real, has, format);
    drawing.blendByAlpha();
    for (const GLenum format : {GL_RGBA8, GL_RGB8}) passes = passes && replaces(real, has, format);
  }
  if (vertexArray != 0) real.DeleteVertexArrays(1, &vertexArray);
  real.DeleteProgram(program);
  return takeErrors(real).empty() && passes;
}

}  // namespace

bool BlendingTrial::passes(const RealGl& real, const Features& has) {
  if (!passes_) passes_ = tried(real, has);
  return *passes_;
}

}  // namespace gluray::present
