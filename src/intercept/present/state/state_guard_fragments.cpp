// StateGuard: fragment tests, blending and masks.
#include "intercept/present/state/state_guard.h"

namespace gluray::present {

using gl::RealGl;

void StateGuard::openFragmentPath() {
  if (features_.rasterizerDiscard) capability(GL_RASTERIZER_DISCARD, false);
  for (int i = 0; i < features_.maxClipDistances; ++i)
    capability(GL_CLIP_PLANE0 + static_cast<GLenum>(i), false);
  clipSpace(false);
  capability(GL_CULL_FACE, false);
  capability(GL_POLYGON_SMOOTH, false);
  capability(GL_STENCIL_TEST, false);
  capability(GL_COLOR_LOGIC_OP, false);
  if (features_.depthBounds) capability(GL_DEPTH_BOUNDS_TEST_EXT, false);
  if (features_.compatibility) {
    capability(GL_ALPHA_TEST, false);
    capability(GL_POLYGON_STIPPLE, false);
  }
  if (features_.indexedDrawBuffers) {
    for (int i = 0; i < features_.maxDrawBuffers; ++i) capability(GL_BLEND, static_cast<GLuint>(i), false);
  } else {
    capability(GL_BLEND, false);
  }
  GLint mode[2] = {GL_FILL, GL_FILL};
  real_.GetIntegerv(GL_POLYGON_MODE, mode);
  if (mode[0] != GL_FILL || (features_.compatibility && mode[1] != GL_FILL)) {
    if (features_.compatibility) {
      keep({[](const RealGl& r, const Undo& u) {
              r.PolygonMode(GL_FRONT, static_cast<GLenum>(u.i[0]));
              r.PolygonMode(GL_BACK, static_cast<GLenum>(u.i[1]));
            },
            0,
            0,
            {mode[0], mode[1]}});
    } else {
      keep({[](const RealGl& r, const Undo& u) {
              r.PolygonMode(GL_FRONT_AND_BACK, static_cast<GLenum>(u.i[0]));
            },
            0,
            0,
            {mode[0]}});
    }
    real_.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  }
  colorMasks();
  coverage();
}

void StateGuard::clipSpace(bool depthsFromZero) {
  if (!features_.clipControl) return;
  const GLint origin = integer(GL_CLIP_ORIGIN), depths = integer(GL_CLIP_DEPTH_MODE);
  const GLenum wanted = depthsFromZero ? GL_ZERO_TO_ONE : GL_NEGATIVE_ONE_TO_ONE;
  if (origin == GL_LOWER_LEFT && static_cast<GLenum>(depths) == wanted) return;
  keep({[](const RealGl& r, const Undo& u) {
          r.ClipControl(static_cast<GLenum>(u.i[0]), static_cast<GLenum>(u.i[1]));
        },
        0,
        0,
        {origin, depths}});
  real_.ClipControl(GL_LOWER_LEFT, wanted);
}

void StateGuard::colorMasks() {
  if (!features_.indexedDrawBuffers) {
    GLboolean m[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
    real_.GetBooleanv(GL_COLOR_WRITEMASK, m);
    if (m[0] && m[1] && m[2] && m[3]) return;
    keep({[](const RealGl& r, const Undo& u) {
            r.ColorMask(u.i[0] != 0, u.i[1] != 0, u.i[2] != 0, u.i[3] != 0);
          },
          0,
          0,
          {m[0], m[1], m[2], m[3]}});
    real_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    return;
  }
  for (GLuint i = 0; i < static_cast<GLuint>(features_.maxDrawBuffers); ++i) {
    GLboolean m[4] = {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE};
    real_.GetBooleani_v(GL_COLOR_WRITEMASK, i, m);
    if (m[0] && m[1] && m[2] && m[3]) continue;
    keep({[](const RealGl& r, const Undo& u) {
            r.ColorMaski(u.index, u.i[0] != 0, u.i[1] != 0, u.i[2] != 0, u.i[3] != 0);
          },
          0,
          i,
          {m[0], m[1], m[2], m[3]}});
    real_.ColorMaski(i, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
}

void StateGuard::coverage() {
  if (!features_.multisample) return;
  capability(GL_SAMPLE_ALPHA_TO_COVERAGE, false);
  capability(GL_SAMPLE_ALPHA_TO_ONE, false);
  capability(GL_SAMPLE_COVERAGE, false);
  if (features_.sampleMask) capability(GL_SAMPLE_MASK, false);
}

void StateGuard::onlySample(int sample) {
  GLint mask = -1;
  real_.GetIntegeri_v(GL_SAMPLE_MASK_VALUE, 0, &mask);
  keep({[](const RealGl& r, const Undo& u) { r.SampleMaski(0, static_cast<GLbitfield>(u.i[0])); },
        0,
        0,
        {mask}});
  capability(GL_MULTISAMPLE, true);
  capability(GL_SAMPLE_MASK, true);
  real_.SampleMaski(0, 1u << sample);
}

void StateGuard::addUp() { blend(2, {GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA}); }

void StateGuard::blendOver() {
  blend(features_.maxDrawBuffers, {GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA});
}

void StateGuard::blendByAlpha() {
  blend(features_.maxDrawBuffers,
        {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA});
}

void StateGuard::blendAs(const scene::Blending& blending) {
  const auto &rgb = blending.rgb, &alpha = blending.alpha;
  const auto factor = [](scene::BlendFactor f) { return static_cast<GLint>(f); };
  blend(1, {factor(rgb.source), factor(rgb.destination), factor(alpha.source), factor(alpha.destination)});
  blendEquation(0, static_cast<GLenum>(rgb.equation), static_cast<GLenum>(alpha.equation));
  if (gl::isPresent(real_.BlendColor)) blendConstant(blending.constant);
  depthWrites(blending.writesDepth);
}

void StateGuard::blendConstant(const glm::vec4& color) {
  GLfloat was[4] = {};
  real_.GetFloatv(GL_BLEND_COLOR, was);
  keep({[](const RealGl& r, const Undo& u) {
          const auto v = [&](size_t i) { return static_cast<GLfloat>(u.d[i]); };
          r.BlendColor(v(0), v(1), v(2), v(3));
        },
        0,
        0,
        {},
        {was[0], was[1], was[2], was[3]}});
  real_.BlendColor(color.r, color.g, color.b, color.a);
}

void StateGuard::blend(int drawBuffers, const std::array<GLint, 4>& factors) {
  for (GLuint i = 0; i < static_cast<GLuint>(drawBuffers); ++i) {
    if (features_.indexedDrawBuffers)
      capability(GL_BLEND, i, true);
    else if (i == 0)
      capability(GL_BLEND, true);
    if (i > 0 && !features_.indexedBlending) continue;
    blendEquation(i, GL_FUNC_ADD, GL_FUNC_ADD);
    blendFactors(i, factors);
  }
}

void StateGuard::encoding(bool on) {
  if (features_.encoding) capability(GL_FRAMEBUFFER_SRGB, on);
}

void StateGuard::colorWrites(const scene::ColorWrites& on) {
  if (on.all()) return;
  for (GLuint i = 0; i < static_cast<GLuint>(features_.maxDrawBuffers); ++i) {
    if (!features_.indexedDrawBuffers) {
      keep({[](const RealGl& r, const Undo&) { r.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); }});
      return real_.ColorMask(on.red, on.green, on.blue, on.alpha);
    }
    keep({[](const RealGl& r, const Undo& u) { r.ColorMaski(u.index, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE); },
          0, i});
    real_.ColorMaski(i, on.red, on.green, on.blue, on.alpha);
  }
}

GLint StateGuard::ofDrawBuffer(GLenum name, GLuint buffer) const {
  if (!features_.indexedBlending) return integer(name);
  GLint value = 0;
  real_.GetIntegeri_v(name, buffer, &value);
  return value;
}

void StateGuard::blendEquation(GLuint buffer, GLenum rgb, GLenum alpha) {
  const GLint wasRgb = ofDrawBuffer(GL_BLEND_EQUATION_RGB, buffer),
              wasAlpha = ofDrawBuffer(GL_BLEND_EQUATION_ALPHA, buffer);
  if (wasRgb == static_cast<GLint>(rgb) && wasAlpha == static_cast<GLint>(alpha)) return;
  if (features_.indexedBlending) {
    keep({[](const RealGl& r, const Undo& u) {
            r.BlendEquationSeparatei(u.index, static_cast<GLenum>(u.i[0]), static_cast<GLenum>(u.i[1]));
          },
          0,
          buffer,
          {wasRgb, wasAlpha}});
    real_.BlendEquationSeparatei(buffer, rgb, alpha);
  } else {
    keep({[](const RealGl& r, const Undo& u) {
            r.BlendEquationSeparate(static_cast<GLenum>(u.i[0]), static_cast<GLenum>(u.i[1]));
          },
          0,
          0,
          {wasRgb, wasAlpha}});
    real_.BlendEquationSeparate(rgb, alpha);
  }
}

void StateGuard::blendFactors(GLuint buffer, const std::array<GLint, 4>& wanted) {
  constexpr GLenum kNames[] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA};
  std::array<GLint, 4> was{};
  for (size_t i = 0; i < 4; ++i) was[i] = ofDrawBuffer(kNames[i], buffer);
  if (was == wanted) return;
  const auto f = [](GLint factor) { return static_cast<GLenum>(factor); };
  if (features_.indexedBlending) {
    keep({[](const RealGl& r, const Undo& u) {
            const auto v = [&](size_t i) { return static_cast<GLenum>(u.i[i]); };
            r.BlendFuncSeparatei(u.index, v(0), v(1), v(2), v(3));
          },
          0, buffer, was});
    real_.BlendFuncSeparatei(buffer, f(wanted[0]), f(wanted[1]), f(wanted[2]), f(wanted[3]));
  } else {
    keep({[](const RealGl& r, const Undo& u) {
            const auto v = [&](size_t i) { return static_cast<GLenum>(u.i[i]); };
            r.BlendFuncSeparate(v(0), v(1), v(2), v(3));
          },
          0, 0, was});
    real_.BlendFuncSeparate(f(wanted[0]), f(wanted[1]), f(wanted[2]), f(wanted[3]));
  }
}

}  // namespace gluray::present
