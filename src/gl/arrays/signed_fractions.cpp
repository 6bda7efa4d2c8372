#include "gl/arrays/signed_fractions.h"

#include "gl/glsl/build_program.h"
#include "gl/real/feedback_stage.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gluray::gl {
namespace {

constexpr const char* kVertex = R"(
IN float asByte, asShort;
OUT float ofByte, ofShort;
void main() {
  ofByte = asByte, ofShort = asShort;
  gl_Position = vec4(0.0, 0.0, 0.0, 1.0);
}
)";
constexpr const char* kFragment = "void main() {}\n";

struct Element {
  int16_t asShort = 0;
  int8_t asByte = 0, unused = 0;
};
struct Fed {
  float ofByte = 0, ofShort = 0;
};

std::vector<Element> allElements() {
  std::vector<Element> all(1 << 16);
  for (size_t i = 0; i < all.size(); ++i)
    all[i] = {static_cast<int16_t>(static_cast<int32_t>(i) - 0x8000), static_cast<int8_t>(i & 0xFF), 0};
  return all;
}

std::string shaderText(bool core, const char* text) {
  const std::string names =
      core ? "#define IN in\n#define OUT out\n" : "#define IN attribute\n#define OUT varying\n";
  return (core ? "#version 150\n" : "#version 120\n") + names + text;
}

GLuint trialProgram(const RealGl& real, bool core) {
  const std::vector<ShaderTexts::Shader> shaders{{GL_VERTEX_SHADER, shaderText(core, kVertex)},
                                                 {GL_FRAGMENT_SHADER, shaderText(core, kFragment)}};
  return buildProgram(real, shaders, [&](GLuint program) {
    real.BindAttribLocation(program, 0, "asByte"), real.BindAttribLocation(program, 1, "asShort");
    const std::array<const char*, 2> fed{"ofByte", "ofShort"};
    real.TransformFeedbackVaryings(program, 2, fed.data(), GL_INTERLEAVED_ATTRIBS);
  });
}

/// Whether the value follows GL 4.2's rule. GL 2.1's rule differs by at least 1 / 65535 for values up to 0.
bool isSame(float fed, int value, int most) {
  return std::abs(double{fed} - double(value) / most) < 4.0 / (1 << 24);
}

bool areSame(std::span<const Fed> fed, const std::vector<Element>& elements) {
  for (size_t i = 0; i < elements.size(); ++i) {
    const Element& e = elements[i];
    if (e.asByte != INT8_MIN && !isSame(fed[i].ofByte, e.asByte, INT8_MAX)) return false;
    if (e.asShort != INT16_MIN && !isSame(fed[i].ofShort, e.asShort, INT16_MAX)) return false;
  }
  return true;
}

/// Vertex array object and buffers of the trial draw. The destructor binds the program's again.
class TrialArrays {
 public:
  TrialArrays(const RealGl& real, const std::vector<Element>& elements, GLsizeiptr fedBytes)
      : real_(real),
        array_(integer(real, GL_VERTEX_ARRAY_BINDING)),
        buffer_(integer(real, GL_ARRAY_BUFFER_BINDING)) {
    real.GenVertexArrays(1, &ours_), real.GenBuffers(2, buffers_.data());
    real.GenTransformFeedbacks(1, &feedback_);
    real.BindVertexArray(ours_);
    real.BindBuffer(GL_ARRAY_BUFFER, buffers_[1]);
    real.BufferData(GL_ARRAY_BUFFER, fedBytes, nullptr, GL_STREAM_READ);
    real.BindBuffer(GL_ARRAY_BUFFER, buffers_[0]);
    real.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(elements.size() * sizeof(Element)),
                    elements.data(), GL_STREAM_DRAW);
    const auto send = [&](GLuint place, GLenum type, size_t at) {
      real.EnableVertexAttribArray(place);
      real.VertexAttribPointer(place, 1, type, GL_TRUE, sizeof(Element), reinterpret_cast<const void*>(at));
    };
    send(0, GL_BYTE, offsetof(Element, asByte)), send(1, GL_SHORT, offsetof(Element, asShort));
  }
  ~TrialArrays() {
    real_.BindVertexArray(static_cast<GLuint>(array_));
    real_.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer_));
    real_.DeleteVertexArrays(1, &ours_), real_.DeleteBuffers(2, buffers_.data());
    real_.DeleteTransformFeedbacks(1, &feedback_);
  }
  TrialArrays(const TrialArrays&) = delete;
  TrialArrays& operator=(const TrialArrays&) = delete;
  GLuint feedback() const { return feedback_; }
  GLuint fed() const { return buffers_[1]; }

 private:
  const RealGl& real_;
  const GLint array_, buffer_;
  GLuint ours_ = 0, feedback_ = 0;
  std::array<GLuint, 2> buffers_{};
};

std::optional<bool> tryOut(const RealGl& real, bool core) {
  const GLuint program = trialProgram(real, core);
  if (program == 0) return std::nullopt;
  const std::vector<Element> elements = allElements();
  const auto bytes = static_cast<GLsizeiptr>(elements.size() * sizeof(Fed));
  std::optional<bool> same;
  {
    const TrialArrays arrays(real, elements, bytes);
    const FeedbackStage stage(real, program, arrays.feedback());
    real.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, arrays.fed());
    real.BeginTransformFeedback(GL_POINTS);
    real.DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(elements.size()));
    real.EndTransformFeedback();
    const MappedFeedback mapped(real, bytes);
    const auto* const fed = static_cast<const Fed*>(mapped.data());
    if (fed) same = areSame({fed, elements.size()}, elements);
  }
  real.DeleteProgram(program);
  return same;
}

}  // namespace

std::optional<bool> SignedFractions::areSymmetric(const RealGl& real, bool core) {
  if (tried_) return symmetric_;
  tried_ = true;
  if (!hasFeedbackObjects(real) || !isPresent(real.BindVertexArray)) return std::nullopt;
  if (integer(real, GL_TRANSFORM_FEEDBACK_ACTIVE) != 0 || isOn(real, GL_RASTERIZER_DISCARD)) {
    tried_ = false;  // a later call tries again
    return std::nullopt;
  }
  const std::optional<bool> same = tryOut(real, core);
  bool failed = false;
  while (real.GetError() != GL_NO_ERROR) failed = true;
  if (!failed) symmetric_ = same;
  return symmetric_;
}

bool SignedFractions::apply(const RealGl& real, bool core, ArrayState& arrays) {
  const bool knew = tried_;
  const auto set = [&](ArraySource& a) {
    if (!a.enabled || !a.normalized || (a.type != GL_BYTE && a.type != GL_SHORT && a.type != GL_INT)) return;
    if (const std::optional<bool> symmetric = areSymmetric(real, core)) a.symmetric = *symmetric;
  };
  for (ArraySource* a :
       {&arrays.vertex, &arrays.normal, &arrays.color, &arrays.secondaryColor, &arrays.fogCoord,
        &arrays.texcoord, &arrays.radius, &arrays.axis, &arrays.instanceColor})
    set(*a);
  for (auto* many :
       {&arrays.texcoordsAbove, &arrays.generic, &arrays.instanceTransform, &arrays.instanceNormal})
    std::ranges::for_each(*many, set);
  return tried_ && !knew;
}

}  // namespace gluray::gl
