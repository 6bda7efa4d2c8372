#include "intercept/present/layer_passes.h"

#include "base/timeline.h"
#include "gl/real/state_queries.h"
#include "intercept/present/raster/program_replay.h"
#include "intercept/present/write_back/texture_upload.h"

#include <GL/glext.h>

#include <algorithm>
#include <optional>

namespace gluray::present {
namespace {

using gl::HeldPass;
using gl::RealGl;

/// A framebuffer object with a held pass's outputs; the destructor restores the binding.
class OwnFramebuffer {
 public:
  OwnFramebuffer(const RealGl& real, const HeldPass& pass)
      : real_(real), was_(gl::integer(real, GL_DRAW_FRAMEBUFFER_BINDING)) {
    real.GenFramebuffers(1, &name_);
    real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, name_);
    std::vector<GLenum> buffers;
    for (const HeldPass::Output& output : pass.outputs) {
      const GLenum attachment = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size());
      buffers.push_back(output.texture ? attachment : GLenum{GL_NONE});
      if (output.texture)
        real.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, attachment, GL_TEXTURE_2D, output.texture,
                                  output.level);
    }
    real.DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  }
  ~OwnFramebuffer() {
    real_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(was_));
    real_.DeleteFramebuffers(1, &name_);
  }
  OwnFramebuffer(const OwnFramebuffer&) = delete;
  OwnFramebuffer& operator=(const OwnFramebuffer&) = delete;
  bool complete() const {
    return real_.CheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }

 private:
  const RealGl& real_;
  GLint was_;
  GLuint name_ = 0;
};

/// Sets blending to the maximum; the destructor restores the program's state.
class KeepLargest {
 public:
  explicit KeepLargest(const RealGl& real)
      : real_(real),
        rgb_(gl::integer(real, GL_BLEND_EQUATION_RGB)),
        alpha_(gl::integer(real, GL_BLEND_EQUATION_ALPHA)),
        on_(gl::isOn(real, GL_BLEND)) {
    real.BlendEquation(GL_MAX);
    real.Enable(GL_BLEND);
  }
  ~KeepLargest() {
    real_.BlendEquationSeparate(static_cast<GLenum>(rgb_), static_cast<GLenum>(alpha_));
    on_ ? real_.Enable(GL_BLEND) : real_.Disable(GL_BLEND);
  }
  KeepLargest(const KeepLargest&) = delete;
  KeepLargest& operator=(const KeepLargest&) = delete;

 private:
  const RealGl& real_;
  GLint rgb_, alpha_;
  bool on_;
};

/// Puts the earlier content into the texture of compared depths; the destructor restores the present one.
class EarlierDepths {
 public:
  EarlierDepths(const RealGl& real, const Features& features, const gl::LayersTarget& target)
      : real_(real), features_(features), target_(target), now_(target.opaqueDepths.size()) {
    StateGuard guard(real, features);
    guard.plainPack();
    guard.texture2D(0, target.opaqueDepth);
    real.GetTexImage(GL_TEXTURE_2D, 0, GL_RG, GL_FLOAT, now_.data());
    put(target.opaqueDepths);
  }
  ~EarlierDepths() { put(now_); }
  EarlierDepths(const EarlierDepths&) = delete;
  EarlierDepths& operator=(const EarlierDepths&) = delete;

 private:
  void put(const std::vector<glm::vec2>& depths) const {
    StateGuard guard(real_, features_);
    guard.plainUnpack();
    guard.texture2D(0, target_.opaqueDepth);
    real_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, target_.size.x, target_.size.y, GL_RG, GL_FLOAT,
                        depths.data());
  }
  const RealGl& real_;
  const Features& features_;
  const gl::LayersTarget& target_;
  std::vector<glm::vec2> now_;
};

/// Clears all draw buffers with the current masks and scissor.
void clearAll(const RealGl& real, const glm::vec4& color) {
  glm::vec4 was(0);
  real.GetFloatv(GL_COLOR_CLEAR_VALUE, &was.x);
  real.ClearColor(color.r, color.g, color.b, color.a);
  real.Clear(GL_COLOR_BUFFER_BIT);
  real.ClearColor(was.r, was.g, was.b, was.a);
}

/// Calls draw(guard) with the framebuffer and the state of a held pass. False if these cannot be set up.
template <class Draw>
bool inPass(const RealGl& real, const Features& features, const HeldPass& pass, Draw&& draw) {
  const OwnFramebuffer framebuffer(real, pass);
  if (!framebuffer.complete()) return false;
  StateGuard guard(real, features);
  guard.openFragmentPath();
  guard.capability(GL_DEPTH_TEST, false);
  guard.viewport(pass.viewport.x, pass.viewport.y, pass.viewport.z, pass.viewport.w);
  guard.scissorOff();
  draw(guard);
  return true;
}

bool drawPass(const RealGl& real, const Features& features, const HeldPass& pass) {
  if (pass.draws.empty() && !pass.clear) return true;
  return inPass(real, features, pass, [&](StateGuard& guard) {
    if (pass.clear) clearAll(real, *pass.clear);
    if (pass.draws.empty()) return;
    std::optional<KeepLargest> largest;
    if (pass.blend == HeldPass::Blend::over)
      guard.blendOver();
    else
      largest.emplace(real);
    replayProgramDraws(real, features, pass.draws);
  });
}

bool isTwoFloats(const RealGl& real, glm::ivec2 size) {
  const auto level = [&](GLenum name) {
    GLint value = 0;
    real.GetTexLevelParameteriv(GL_TEXTURE_2D, 0, name, &value);
    return value;
  };
  return level(GL_TEXTURE_WIDTH) == size.x && level(GL_TEXTURE_HEIGHT) == size.y &&
         level(GL_TEXTURE_RED_SIZE) == 32 && level(GL_TEXTURE_GREEN_SIZE) == 32 &&
         level(GL_TEXTURE_RED_TYPE) == GL_FLOAT;
}

}  // namespace

bool readDepths(const RealGl& real, const Features& features, GLint unit, glm::ivec2 size,
                std::vector<glm::vec2>& out) {
  StateGuard guard(real, features);
  guard.plainPack();
  guard.activeTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  if (!isTwoFloats(real, size)) return false;
  out.resize(static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  real.GetTexImage(GL_TEXTURE_2D, 0, GL_RG, GL_FLOAT, out.data());
  return takeErrors(real).empty();
}

bool writeTexture(const RealGl& real, const Features& features, GLuint texture, glm::ivec2 size,
                  const uint32_t* pixels) {
  const timeline::Span span("write back");
  StateGuard guard(real, features);
  guard.plainUnpack();
  guard.texture2D(0, texture);  // a GL error if it has another target
  if (!takeErrors(real).empty() || !gl::isRgba8(real, size) || makesMipmaps(real, features)) return false;
  real.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  return takeErrors(real).empty();
}

bool clearResult(const RealGl& real, const Features& features, const gl::LayersTarget& target) {
  const std::vector<uint32_t> nothing(target.opaqueDepths.size());
  return writeTexture(real, features, target.result, target.size, nothing.data());
}

bool drawLayers(const RealGl& real, const Features& features, const gl::LayersTarget& target) {
  if (target.written && !clearResult(real, features, target)) return false;
  {
    const EarlierDepths depths(real, features, target);
    if (!drawPass(real, features, target.depths)) return false;
  }
  if (!drawPass(real, features, target.surfaces)) return false;
  return std::all_of(target.later.begin(), target.later.end(),
                     [&](const HeldPass& pass) { return drawPass(real, features, pass); });
}

bool showImage(const RealGl& real, const Features& features, const gl::LayersTarget& target) {
  for (const HeldPass& pass : target.later)
    if (pass.clear && !drawPass(real, features, pass)) return false;
  return writeTexture(real, features, target.result, target.size, target.image.data());
}

bool countPixels(const RealGl& real, const Features& features, const HeldPass& pass, GLuint texture,
                 glm::ivec2 size, uint64_t pixels) {
  std::vector<uint32_t> was(static_cast<size_t>(size.x) * static_cast<size_t>(size.y)), marks(was.size());
  {
    StateGuard guard(real, features);
    guard.plainPack();
    guard.texture2D(0, texture);
    if (!gl::isRgba8(real, size)) return false;
    real.GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, was.data());
  }
  if (pixels > marks.size()) return false;
  std::fill_n(marks.begin(), pixels, ~uint32_t{0});
  if (!writeTexture(real, features, texture, size, marks.data())) return false;
  const bool counted = inPass(real, features, pass, [&](StateGuard& guard) {
    guard.colorWrites({false, false, false, false});
    replayProgramDraws(real, features, pass.draws);
  });
  return writeTexture(real, features, texture, size, was.data()) && counted && takeErrors(real).empty();
}

}  // namespace gluray::present
