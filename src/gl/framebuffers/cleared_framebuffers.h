// Tracks whether the draw framebuffer contains only a clear, how its depths may have changed, and whether
// images in it are already anti-aliased. A part of each Context, GL thread.
#pragma once
#include "gl/basics/failsafe.h"
#include "gl/batch/batch.h"
#include "gl/batch/cleared_target.h"
#include "gl/clock/frame_clock.h"
#include "gl/framebuffers/antialiased_image.h"
#include "gl/shadow/shadow_state.h"
#include "settings/samples.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>

namespace gluray::gl {

class ClearedFramebuffers {
 public:
  ClearedFramebuffers(ShadowState& shadow, const FrameClock& clock, const Failsafe& failsafe)
      : shadow_(shadow), clock_(clock), failsafe_(failsafe) {}

  /// The draw framebuffer's clear, if it contains nothing else. Tracked only if OpenGL is a software
  /// renderer.
  const std::optional<ClearedTarget>& target() const { return cleared_; }
  /// The clear under the whole image of `snapshot`, if the image may be uploaded over it.
  std::optional<ClearedTarget> under(const scene::Snapshot& snapshot, const BatchKey& key) const;
  /// Call after a glClear.
  void clear(GLbitfield mask);
  /// Reports that the draw framebuffer may have been drawn or copied into.
  void forget() {
    forgetClear();
    if (antialiased_.any() || antialiased_.copied()) antialiased_ = {};
  }
  /// Reports that draws may go to another buffer of the framebuffer.
  void forgetClear() { cleared_.reset(), nextDepths(); }
  /// Reports that the real OpenGL draws into the framebuffer next, and whether depths may become smaller or
  /// larger.
  void drawing(bool smaller, bool larger);
  /// A number that stays the same only while the draw framebuffer is the same and none of its depths has
  /// become larger or, if `reversed`, smaller.
  uint64_t depthEpoch(bool reversed) const { return depthEpochs_[reversed ? 1 : 0]; }
  void forgetAntialiased() { antialiased_ = {}; }
  /// Reports that the texture bound to `target`, which may be attached to the framebuffer, was written.
  void imageSent(GLenum target);
  /// Call after imageSent() if the pixels were copied from region `from` of the read framebuffer.
  void imageCopied(GLenum target, GLint level, glm::ivec2 offset, const scene::Region& from);

  /// Reports that an image was written into the framebuffer: uploaded over its clear, or drawn.
  void wrote(GLuint framebuffer, bool uploaded) {
    if (framebuffer != 0) uploads_ = uploaded;
  }

  const AntialiasedImage& antialiased() const { return antialiased_; }
  /// Reports that images of averages were written into the region of the draw framebuffer, which had one
  /// colour.
  void holdsAntialiased(GLuint framebuffer, GLenum drawBuffer, const scene::Region& region) {
    if (framebuffer != 0 && samplesPerPixel(shadow_.settings) > 1)
      antialiased_ = AntialiasedImage(framebuffer, drawBuffer, region);
  }
  /// Reports that an image of averages was written over the contents that `before` describes.
  void wroteAntialiased(const AntialiasedImage& before, const BatchKey& key);

 private:
  bool holdsBytes(GLenum drawBuffer) const;
  void nextDepths() { ++depthEpochs_[0], ++depthEpochs_[1]; }

  ShadowState& shadow_;
  const FrameClock& clock_;
  const Failsafe& failsafe_;
  std::optional<ClearedTarget> cleared_;
  bool uploads_ = false;  // whether the last image in a framebuffer object was uploaded
  AntialiasedImage antialiased_;
  std::array<uint64_t, 2> depthEpochs_{};
};

}  // namespace gluray::gl
