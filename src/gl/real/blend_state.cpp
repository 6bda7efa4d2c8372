#include "gl/real/blend_state.h"

#include "gl/real/state_queries.h"

#include <GL/glext.h>
#include <glm/gtc/type_ptr.hpp>

namespace gluray::gl {
namespace {

using scene::BlendEquation;
using scene::BlendFactor;

std::optional<BlendEquation> equationOf(GLint value) {
  const auto equation = static_cast<BlendEquation>(value);
  switch (equation) {
    case BlendEquation::add:
    case BlendEquation::min:
    case BlendEquation::max:
    case BlendEquation::subtract:
    case BlendEquation::reverseSubtract: return equation;
  }
  return std::nullopt;
}

std::optional<BlendFactor> factorOf(GLint value) {
  const bool known = value == GL_ZERO || value == GL_ONE ||
                     (value >= GL_SRC_COLOR && value <= GL_SRC_ALPHA_SATURATE) ||
                     (value >= GL_CONSTANT_COLOR && value <= GL_ONE_MINUS_CONSTANT_ALPHA);
  return known ? std::optional(static_cast<BlendFactor>(value)) : std::nullopt;
}

std::optional<scene::Blending::Part> readPart(const RealGl& real, GLenum equation, GLenum source,
                                              GLenum destination) {
  const auto e = equationOf(integer(real, equation));
  const auto s = factorOf(integer(real, source)), d = factorOf(integer(real, destination));
  if (!e || !s || !d) return std::nullopt;
  return scene::Blending::Part{*e, *s, *d};
}

}  // namespace

std::optional<scene::Blending> readBlending(const RealGl& real, bool writesDepth) {
  scene::Blending blending;
  blending.writesDepth = writesDepth;
  if (!isOn(real, GL_BLEND)) return blending;
  const auto rgb = readPart(real, GL_BLEND_EQUATION_RGB, GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB);
  const auto alpha = readPart(real, GL_BLEND_EQUATION_ALPHA, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA);
  if (!rgb || !alpha) return std::nullopt;
  blending.rgb = *rgb, blending.alpha = *alpha;
  if (isPresent(real.BlendColor)) {
    real.GetFloatv(GL_BLEND_COLOR, glm::value_ptr(blending.constant));
    blending.constant = glm::clamp(blending.constant, 0.0f, 1.0f);
  }
  return blending;
}

}  // namespace gluray::gl
