// The settings of a frame: read when the frame begins, constant until it ends. A part of each Context, GL
// thread.
#pragma once
#include "gl/clock/context_info.h"

#include <cstdint>

namespace gluray::gl {

/// The engine that draws. `automatic` becomes `always` if the context is off, if settings change the image,
/// so that the real OpenGL would show a different one, if the renderer is `null`, which measures interception
/// alone, or if `asked`: somebody queries the drawn objects (DrawnObjects).
Engine engineOf(const ContextInfo& info, const Settings& settings, bool asked = false);

/// Number of tracing threads, for EngineChoice.
int threadsOf(const Settings& settings);

class FrameSettings {
 public:
  /// Takes the source's current settings or, without a source, those of `info`.
  explicit FrameSettings(const ContextInfo& info)
      : source_(info.source), now_(source_ ? *source_->current() : info.settings) {}

  const Settings& now() const { return now_; }
  /// Number of the last frame that has begun, in the source's count; 0 without a source.
  uint64_t frame() const noexcept { return source_ ? source_->begun().frame : 0; }
  /// Number of the frame that any context currently draws; 0 without a source.
  uint64_t sourceFrame() const noexcept { return source_ ? source_->frame() : 0; }
  /// Call when a frame has been shown and before the first clear of the next one: counts it.
  void endFrame() noexcept {
    if (source_) source_->endFrame();
  }
  void beginFrame() noexcept {
    if (source_) source_->beginFrame();
  }
  /// Call after endFrame() and beginFrame(): takes the current settings, except those that are fixed for the
  /// context. Returns whether the source had new ones.
  bool takeCurrent();

 private:
  SettingsSource* const source_;
  Settings now_;
  uint64_t version_ = 0;  // the source's version when now_ was taken
};

}  // namespace gluray::gl
