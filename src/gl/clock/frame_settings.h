// The settings of a frame: read when the frame begins, constant until it ends. A part of each Context, GL
// thread.
#pragma once
#include "gl/clock/context_info.h"

#include <cstdint>

namespace gluray::gl {

/// The engine that draws. `automatic` becomes `always` if settings change the image, so that the real
/// OpenGL would show another one, or if the renderer is `null` (to measure interception alone), or if
/// somebody asks for what is drawn (DrawnObjects).
Engine engineOf(const ContextInfo& info, const Settings& settings, bool asked = false);

/// Number of tracing threads, for EngineChoice.
int threadsOf(const Settings& settings);

class FrameSettings {
 public:
  /// Takes the source's current settings or, without a source, those of `info`.
  explicit FrameSettings(const ContextInfo& info)
      : source_(info.source), now_(source_ ? *source_->current() : info.settings) {}

  const Settings& now() const { return now_; }
  /// The number of the last frame that has begun, as the source counts; 0: without a source.
  uint64_t frame() const noexcept { return source_ ? source_->begun().frame : 0; }
  /// The number of the frame that any context draws now; 0: without a source.
  uint64_t sourceFrame() const noexcept { return source_ ? source_->frame() : 0; }
  /// Call when a frame has been shown, and before the first clear of the next: counts it.
  void endFrame() noexcept {
    if (source_) source_->endFrame();
  }
  void beginFrame() noexcept {
    if (source_) source_->beginFrame();
  }
  /// Call after these: takes the current settings, except those that are fixed for the context. Returns
  /// whether the source had new ones.
  bool takeCurrent();

 private:
  SettingsSource* const source_;
  Settings now_;
  uint64_t version_ = 0;  // the source's version when now_ was taken
};

}  // namespace gluray::gl
