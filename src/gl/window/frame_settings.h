// The settings of a frame: taken when it begins, the same until it ends. A part of each Context, GL thread.
#pragma once
#include "gl/context_info.h"

#include <cstdint>

namespace gluray::gl {

/// Who draws: `automatic` holds only while the real OpenGL would show the same picture. Interception alone is
/// priced with everything held back.
Engine engineOf(const ContextInfo& info, const Settings& settings);

/// Threads that trace, as EngineChoice takes them into account.
int threadsOf(const Settings& settings);

class FrameSettings {
 public:
  /// Those of the source of now or, where there is none, of `info`.
  explicit FrameSettings(const ContextInfo& info)
      : source_(info.source), now_(source_ ? *source_->current() : info.settings) {}

  const Settings& now() const { return now_; }
  /// At the beginning of a frame: takes the settings of now, but for those that last as long as the context.
  /// Whether they are others.
  bool take();

 private:
  const SettingsSource* const source_;
  Settings now_;
  uint64_t version_ = 0;  // of the source when they were taken
};

}  // namespace gluray::gl
