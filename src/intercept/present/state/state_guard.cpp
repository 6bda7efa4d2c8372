#include "intercept/present/state/state_guard.h"

namespace gluray::present {

using gl::RealGl;

PendingErrors takeErrors(const RealGl& real) {
  PendingErrors errors;
  while (errors.size() < 16) {
    const GLenum error = real.GetError();
    if (error == GL_NO_ERROR) break;
    errors.push_back(error);
  }
  return errors;
}

StateGuard::StateGuard(const RealGl& real, const Features& features) : real_(real), features_(features) {
  log_.reserve(64);
  // The program's debug callback must not receive messages about our calls.
  if (features.debugOutput) capability(GL_DEBUG_OUTPUT, false);
}

StateGuard::~StateGuard() {
  program_.reset();  // before transform feedback goes on
  for (auto undo = log_.rbegin(); undo != log_.rend(); ++undo) undo->restore(real_, *undo);
}

GLint StateGuard::integer(GLenum name) const {
  GLint value = 0;
  real_.GetIntegerv(name, &value);
  return value;
}

void StateGuard::capability(GLenum name, bool on) {
  const bool was = real_.IsEnabled(name) != GL_FALSE;
  if (was == on) return;
  if (was) {
    keep({[](const RealGl& r, const Undo& u) { r.Enable(u.name); }, name});
    real_.Disable(name);
  } else {
    keep({[](const RealGl& r, const Undo& u) { r.Disable(u.name); }, name});
    real_.Enable(name);
  }
}

void StateGuard::capability(GLenum name, GLuint index, bool on) {
  const bool was = real_.IsEnabledi(name, index) != GL_FALSE;
  if (was == on) return;
  if (was) {
    keep({[](const RealGl& r, const Undo& u) { r.Enablei(u.name, u.index); }, name, index});
    real_.Disablei(name, index);
  } else {
    keep({[](const RealGl& r, const Undo& u) { r.Disablei(u.name, u.index); }, name, index});
    real_.Enablei(name, index);
  }
}

void StateGuard::drawInto(const scene::Snapshot& snapshot, GLenum func) {
  openFragmentPath();
  colorWrites(snapshot.colorWrites);
  encoding(snapshot.encodes);
  depthTest(func);
  depthRange(snapshot.camera.depthNear, snapshot.camera.depthFar);
  clipSpace(snapshot.camera.depthsFromZero);
  const glm::ivec4& v = snapshot.camera.viewport;
  viewport(v.x, v.y, v.z, v.w);
  const scene::Region& r = snapshot.region;
  scissor(r.x, r.y, r.width, r.height);
  if (features_.multisample) capability(GL_MULTISAMPLE, snapshot.samples > 1);
}

void StateGuard::depthTest(GLenum func) {
  capability(GL_DEPTH_TEST, true);
  const GLint was = integer(GL_DEPTH_FUNC);
  if (was != static_cast<GLint>(func)) {
    keep({[](const RealGl& r, const Undo& u) { r.DepthFunc(static_cast<GLenum>(u.i[0])); }, 0, 0, {was}});
    real_.DepthFunc(func);
  }
  depthWrites(true);
}

void StateGuard::depthWrites(bool on) {
  const bool was = integer(GL_DEPTH_WRITEMASK) != 0;
  if (was == on) return;
  keep({[](const RealGl& r, const Undo& u) { r.DepthMask(u.i[0] != 0); }, 0, 0, {was}});
  real_.DepthMask(on);
}

void StateGuard::polygonOffset(float factor, float units) {
  capability(GL_POLYGON_OFFSET_FILL, true);
  GLdouble before[3] = {};  // factor, units, clamp
  real_.GetDoublev(GL_POLYGON_OFFSET_FACTOR, &before[0]);
  real_.GetDoublev(GL_POLYGON_OFFSET_UNITS, &before[1]);
  if (features_.offsetClamp) real_.GetDoublev(GL_POLYGON_OFFSET_CLAMP, &before[2]);
  keep({[](const RealGl& r, const Undo& u) {
          const auto value = [&](size_t i) { return static_cast<GLfloat>(u.d[i]); };
          if (u.d[2] != 0)
            r.PolygonOffsetClamp(value(0), value(1), value(2));
          else
            r.PolygonOffset(value(0), value(1));
        },
        0,
        0,
        {},
        {before[0], before[1], before[2]}});
  real_.PolygonOffset(factor, units);
}

void StateGuard::depthRange(double zNear, double zFar) {
  GLdouble range[2] = {0, 1};
  if (features_.indexedViewports) {
    real_.GetDoublei_v(GL_DEPTH_RANGE, 0, range);
    if (range[0] == zNear && range[1] == zFar) return;
    keep({[](const RealGl& r, const Undo& u) { r.DepthRangeIndexed(0, u.d[0], u.d[1]); },
          0,
          0,
          {},
          {range[0], range[1]}});
    real_.DepthRangeIndexed(0, zNear, zFar);
  } else {
    real_.GetDoublev(GL_DEPTH_RANGE, range);
    if (range[0] == zNear && range[1] == zFar) return;
    keep({[](const RealGl& r, const Undo& u) { r.DepthRange(u.d[0], u.d[1]); },
          0,
          0,
          {},
          {range[0], range[1]}});
    real_.DepthRange(zNear, zFar);
  }
}

void StateGuard::viewport(int x, int y, int width, int height) {
  if (features_.indexedViewports) {
    GLfloat v[4];
    real_.GetFloati_v(GL_VIEWPORT, 0, v);
    if (v[0] == static_cast<GLfloat>(x) && v[1] == static_cast<GLfloat>(y) &&
        v[2] == static_cast<GLfloat>(width) && v[3] == static_cast<GLfloat>(height))
      return;
    keep({[](const RealGl& r, const Undo& u) {
            r.ViewportIndexedf(0, static_cast<GLfloat>(u.d[0]), static_cast<GLfloat>(u.d[1]),
                               static_cast<GLfloat>(u.d[2]), static_cast<GLfloat>(u.d[3]));
          },
          0,
          0,
          {},
          {v[0], v[1], v[2], v[3]}});
    real_.ViewportIndexedf(0, static_cast<GLfloat>(x), static_cast<GLfloat>(y), static_cast<GLfloat>(width),
                           static_cast<GLfloat>(height));
  } else {
    GLint v[4];
    real_.GetIntegerv(GL_VIEWPORT, v);
    if (v[0] == x && v[1] == y && v[2] == width && v[3] == height) return;
    keep({[](const RealGl& r, const Undo& u) { r.Viewport(u.i[0], u.i[1], u.i[2], u.i[3]); },
          0,
          0,
          {v[0], v[1], v[2], v[3]}});
    real_.Viewport(x, y, width, height);
  }
}

void StateGuard::scissor(int x, int y, int width, int height) {
  GLint s[4];
  if (features_.indexedViewports) {
    real_.GetIntegeri_v(GL_SCISSOR_BOX, 0, s);
    keep({[](const RealGl& r, const Undo& u) { r.ScissorIndexed(0, u.i[0], u.i[1], u.i[2], u.i[3]); },
          0,
          0,
          {s[0], s[1], s[2], s[3]}});
    real_.ScissorIndexed(0, x, y, width, height);
    capability(GL_SCISSOR_TEST, 0, true);
  } else {
    real_.GetIntegerv(GL_SCISSOR_BOX, s);
    keep({[](const RealGl& r, const Undo& u) { r.Scissor(u.i[0], u.i[1], u.i[2], u.i[3]); },
          0,
          0,
          {s[0], s[1], s[2], s[3]}});
    real_.Scissor(x, y, width, height);
    capability(GL_SCISSOR_TEST, true);
  }
}

void StateGuard::scissorOff() {
  if (features_.indexedViewports)
    capability(GL_SCISSOR_TEST, 0, false);
  else
    capability(GL_SCISSOR_TEST, false);
}

void StateGuard::drawToWindow(GLenum buffer) {
  if (features_.readFramebuffers) {
    const GLint bound = integer(GL_DRAW_FRAMEBUFFER_BINDING);
    const auto rebind = [](const RealGl& r, const Undo& u) {
      r.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(u.i[0]));
    };
    if (bound != 0) keep({rebind, 0, 0, {bound}}), real_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  }
  const GLint was = integer(GL_DRAW_BUFFER);
  if (was == static_cast<GLint>(buffer)) return;
  keep({[](const RealGl& r, const Undo& u) { r.DrawBuffer(static_cast<GLenum>(u.i[0])); }, 0, 0, {was}});
  real_.DrawBuffer(buffer);
}

void StateGuard::readFrom(GLuint framebuffer, GLenum buffer) {
  const GLint bound = features_.readFramebuffers ? integer(GL_READ_FRAMEBUFFER_BINDING) : 0;
  if (features_.readFramebuffers && bound != static_cast<GLint>(framebuffer)) {
    keep({[](const RealGl& r, const Undo& u) {
            r.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(u.i[0]));
          },
          0,
          0,
          {bound}});
    real_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  }
  const GLint was = integer(GL_READ_BUFFER);
  if (was == static_cast<GLint>(buffer)) return;
  keep({[](const RealGl& r, const Undo& u) { r.ReadBuffer(static_cast<GLenum>(u.i[0])); }, 0, 0, {was}});
  real_.ReadBuffer(buffer);
}

void StateGuard::activeTexture(GLenum unit) {
  const GLint was = integer(GL_ACTIVE_TEXTURE);
  if (was == static_cast<GLint>(unit)) return;
  keep({[](const RealGl& r, const Undo& u) { r.ActiveTexture(static_cast<GLenum>(u.i[0])); }, 0, 0, {was}});
  real_.ActiveTexture(unit);
}

void StateGuard::texture(int unit, GLenum target, GLenum binding, GLuint texture) {
  const GLenum name = GL_TEXTURE0 + static_cast<GLenum>(unit);
  activeTexture(name);
  const GLint was = integer(binding);
  if (was == static_cast<GLint>(texture)) return;
  keep({[](const RealGl& r, const Undo& u) {
          r.ActiveTexture(u.name);
          r.BindTexture(u.index, static_cast<GLuint>(u.i[0]));
        },
        name,
        target,
        {was}});
  real_.BindTexture(target, texture);
}

void StateGuard::textureMultisample(int unit, GLuint name) {
  texture(unit, GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE, name);
}

void StateGuard::texture2D(int unit, GLuint name) {
  texture(unit, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D, name);
  if (!features_.samplerObjects) return;
  const GLint sampler = integer(GL_SAMPLER_BINDING);
  if (sampler == 0) return;
  keep({[](const RealGl& r, const Undo& u) { r.BindSampler(u.index, static_cast<GLuint>(u.i[0])); },
        0,
        static_cast<GLuint>(unit),
        {sampler}});
  real_.BindSampler(static_cast<GLuint>(unit), 0);
}

void StateGuard::program(GLuint program) {
  if (features_.transformFeedbackPause && integer(GL_TRANSFORM_FEEDBACK_ACTIVE) &&
      !integer(GL_TRANSFORM_FEEDBACK_PAUSED)) {
    keep({[](const RealGl& r, const Undo&) { r.ResumeTransformFeedback(); }});
    real_.PauseTransformFeedback();
  }
  if (!program_) program_.emplace(real_);
  program_->use(program);
}

void StateGuard::vertexArray(GLuint array) {
  const GLint was = integer(GL_VERTEX_ARRAY_BINDING);
  if (was == static_cast<GLint>(array)) return;
  keep({[](const RealGl& r, const Undo& u) { r.BindVertexArray(static_cast<GLuint>(u.i[0])); }, 0, 0, {was}});
  real_.BindVertexArray(array);
}

void StateGuard::lastVertexProvokes() {
  if (features_.version < 32 || integer(GL_PROVOKING_VERTEX) == GL_LAST_VERTEX_CONVENTION) return;
  keep({[](const RealGl& r, const Undo&) { r.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION); }});
  real_.ProvokingVertex(GL_LAST_VERTEX_CONVENTION);
}

}  // namespace gluray::present
