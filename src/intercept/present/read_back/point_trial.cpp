#include "intercept/present/read_back/point_trial.h"

#include "gl/glsl/build_program.h"
#include "gl/real/state_queries.h"
#include "intercept/present/read_back/sample_copy.h"
#include "intercept/present/state/state_guard.h"

#include <GL/glext.h>

#include <array>
#include <cmath>
#include <string>

namespace gluray::present {
namespace {

using gl::RealGl;

constexpr int kPointsSize = 16;  // of the framebuffer, pixels

constexpr const char* kOwnVertex = R"(
uniform vec3 place;
void main() {
  gl_Position = vec4(place.xy, 0.0, 1.0);
  gl_PointSize = place.z;
}
)";
constexpr const char* kFragment = R"(#version 150
out vec4 color;
void main() {
  color = vec4(gl_PointCoord, 1.0, 1.0);
}
)";

struct TrialPoint {
  glm::dvec2 at;  // window, pixels
  double size;    // pixels
};
/// Sizes and positions that halves, and bits of a pixel's grid, tell apart.
constexpr std::array<TrialPoint, 3> kPoints = {{{{8, 8}, 6}, {{7.3125, 8.625}, 9}, {{8.5, 7.75}, 5.5}}};

/// A multisampled framebuffer of floats, and one that takes its resolved colours. Deletes both.
class PointImages {
 public:
  PointImages(const RealGl& real, int samples)
      : real_(real), bound_(gl::integer(real, GL_RENDERBUFFER_BINDING)) {
    real.GenRenderbuffers(2, names_.data());
    real.BindRenderbuffer(GL_RENDERBUFFER, names_[0]);
    real.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA32F, kPointsSize, kPointsSize);
    real.GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &samples_);
    real.BindRenderbuffer(GL_RENDERBUFFER, names_[1]);
    real.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA32F, kPointsSize, kPointsSize);
    real.BindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(bound_));
  }
  ~PointImages() { real_.DeleteRenderbuffers(2, names_.data()); }
  PointImages(const PointImages&) = delete;
  PointImages& operator=(const PointImages&) = delete;
  int samples() const { return samples_; }
  /// Attaches one of them to the framebuffer that is bound for drawing.
  bool attach(size_t which) const {
    real_.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names_[which]);
    real_.DrawBuffer(GL_COLOR_ATTACHMENT0);
    return real_.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }

 private:
  const RealGl& real_;
  const GLint bound_;
  std::array<GLuint, 2> names_{};
  GLint samples_ = 0;
};

using PointPixels = std::array<glm::vec4, size_t{kPointsSize} * kPointsSize>;

void drawPoint(const RealGl& real, const Features& has, GLuint program, const TrialPoint& point) {
  const glm::vec2 ndc(point.at * (2.0 / kPointsSize) - 1.0);
  real.Uniform3f(real.GetUniformLocation(program, "place"), ndc.x, ndc.y, static_cast<GLfloat>(point.size));
  if (!has.compatibility) return real.DrawArrays(GL_POINTS, 0, 1);
  real.Begin(GL_POINTS);
  real.Vertex2f(0, 0);
  real.End();
}

/// Draws the point and resolves its image.
bool draw(const RealGl& real, const Features& has, GLuint program, const PointImages& images,
          const TrialPoint& point, PointPixels& out) {
  const CopyFramebuffer drawn(real);
  if (!images.attach(0)) return false;
  constexpr std::array<GLfloat, 4> kNone{};
  real.ClearBufferfv(GL_COLOR, 0, kNone.data());
  drawPoint(real, has, program, point);
  const CopyFramebuffer resolved(real);  // blits come from the framebuffer that was drawn into
  if (!images.attach(1)) return false;
  real.BlitFramebuffer(0, 0, kPointsSize, kPointsSize, 0, 0, kPointsSize, kPointsSize, GL_COLOR_BUFFER_BIT,
                       GL_NEAREST);
  real.BindFramebuffer(GL_READ_FRAMEBUFFER, resolved.name());
  real.ReadPixels(0, 0, kPointsSize, kPointsSize, GL_RGBA, GL_FLOAT, out.data());
  return true;
}

/// The shift of all pixels that the point covers wholly, if it is the same (GL 4.6, equation 14.1; point
/// coordinates run from the upper left).
std::optional<glm::vec2> shiftOf(const PointPixels& pixels, const TrialPoint& point) {
  constexpr double kSame = 1e-3;  // pixels
  std::optional<glm::dvec2> shift;
  for (int y = 0; y < kPointsSize; ++y)
    for (int x = 0; x < kPointsSize; ++x) {
      const glm::dvec2 center(x + 0.5, y + 0.5);
      const glm::dvec2 from = glm::abs(center - point.at) + 0.5;
      if (std::max(from.x, from.y) > 0.5 * point.size - 0.01) continue;
      const glm::dvec4 seen(pixels[static_cast<size_t>(y * kPointsSize + x)]);
      const glm::dvec2 at = point.at + (glm::dvec2(seen.x, 1 - seen.y) - 0.5) * point.size;
      if (!(std::abs(seen.z - 1) < 1e-6)) return std::nullopt;
      if (!shift) shift = at - center;
      if (!(glm::length(at - center - *shift) < kSame)) return std::nullopt;
    }
  if (!shift) return std::nullopt;
  return glm::vec2(glm::round(*shift * 256.0) / 256.0);
}

GLuint pointProgram(const RealGl& real, bool compatibility) {
  const std::string version = compatibility ? "#version 150 compatibility\n" : "#version 150\n";
  return gl::buildProgram(real, {{GL_VERTEX_SHADER, version + kOwnVertex}, {GL_FRAGMENT_SHADER, kFragment}});
}

std::optional<glm::vec2> tryPoints(const RealGl& real, const Features& has, GLuint program, int samples) {
  GLuint vertexArray = 0;
  if (!has.compatibility) real.GenVertexArrays(1, &vertexArray);
  std::optional<glm::vec2> shift;
  bool same = true;
  {
    StateGuard guard(real, has);
    guard.openFragmentPath();
    guard.capability(GL_DEPTH_TEST, false);
    guard.capability(GL_MULTISAMPLE, true);
    guard.capability(GL_PROGRAM_POINT_SIZE, true);
    if (has.compatibility) guard.capability(GL_POINT_SPRITE, true);
    if (has.encoding) guard.encoding(false);
    guard.viewport(0, 0, kPointsSize, kPointsSize);
    // Mesa 22 draws no points while only the scissor tests of other viewports are on.
    guard.scissor(0, 0, kPointsSize, kPointsSize);
    guard.plainPack();
    guard.program(program);
    if (vertexArray != 0) guard.vertexArray(vertexArray);
    const PointImages images(real, samples);
    same = images.samples() == samples;
    PointPixels pixels{};
    for (const TrialPoint& point : kPoints) {
      same = same && draw(real, has, program, images, point, pixels);
      const std::optional<glm::vec2> seen = same ? shiftOf(pixels, point) : std::nullopt;
      same = same && seen && (!shift || *shift == *seen);
      shift = seen;
    }
  }
  if (vertexArray != 0) real.DeleteVertexArrays(1, &vertexArray);
  return same ? shift : std::nullopt;
}

}  // namespace

std::optional<glm::vec2> tryPointCoordinates(const RealGl& real, const Features& has, int samples) {
  if (has.version < 32 || !has.readFramebuffers) return std::nullopt;
  const StateGuard guard(real, has);  // the program's debug callback hears nothing of ours
  const GLuint program = pointProgram(real, has.compatibility);
  if (program == 0) return takeErrors(real), std::nullopt;
  const std::optional<glm::vec2> shift = tryPoints(real, has, program, samples);
  real.DeleteProgram(program);
  return takeErrors(real).empty() ? shift : std::nullopt;
}

}  // namespace gluray::present
