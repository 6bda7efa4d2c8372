// What the draw framebuffer is known to hold where it is but a clear, and which pictures in it are
// anti-aliased already. A part of each Context, GL thread.
#pragma once
#include "gl/batch/batch.h"
#include "gl/batch/cleared_target.h"
#include "gl/failsafe.h"
#include "gl/state/shadow_state.h"
#include "gl/window/antialiased_picture.h"
#include "gl/window/frame_clock.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <optional>

namespace gluray::gl {

class ClearedFramebuffers {
 public:
  ClearedFramebuffers(ShadowState& shadow, const FrameClock& clock, const Failsafe& failsafe)
      : shadow_(shadow), clock_(clock), failsafe_(failsafe) {}

  /// What the draw framebuffer holds, where that is but a clear and worth knowing.
  const std::optional<ClearedTarget>& target() const { return cleared_; }
  /// The same of what lies under a picture of `snapshot`.
  std::optional<ClearedTarget> under(const scene::Snapshot& snapshot, const BatchKey& key) const;
  /// After a glClear.
  void clear(GLbitfield mask);
  /// Something may have been drawn, or sent, into the draw framebuffer.
  void forget() { forgetClear(), antialiased_ = {}; }
  /// Draws may go to another buffer of the framebuffer.
  void forgetClear() { cleared_.reset(); }
  void forgetAntialiased() { antialiased_ = {}; }
  /// An image was sent into the texture bound to `target`, which may be attached to the framebuffer.
  void imageSent(GLenum target);
  /// After that, where it was a part of the framebuffer's picture that was copied.
  void imageCopied(GLenum target, GLint level, glm::ivec2 offset, const scene::Region& from);

  const AntialiasedPicture& antialiased() const { return antialiased_; }
  /// A picture of averages was written over those that `before` tells of.
  void wroteAntialiased(const AntialiasedPicture& before, const BatchKey& key);

 private:
  ShadowState& shadow_;
  const FrameClock& clock_;
  const Failsafe& failsafe_;
  std::optional<ClearedTarget> cleared_;
  AntialiasedPicture antialiased_;
};

}  // namespace gluray::gl
