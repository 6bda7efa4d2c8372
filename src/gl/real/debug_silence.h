// Keeps the errors of our own calls from the program's debug callback and message log. GL thread, context
// current.
#pragma once
#include "gl/real/real.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

namespace gluray::gl {

/// While it lives, the real OpenGL reports no messages.
class DebugSilence {
 public:
  /// `hasOutput`: the context has GL_DEBUG_OUTPUT (RareState::debugOutput).
  DebugSilence(const RealGl& real, bool hasOutput)
      : real_(real), on_(hasOutput && isOn(real, GL_DEBUG_OUTPUT)) {
    if (on_) real.Disable(GL_DEBUG_OUTPUT);
  }
  ~DebugSilence() {
    if (on_) real_.Enable(GL_DEBUG_OUTPUT);
  }
  DebugSilence(const DebugSilence&) = delete;
  DebugSilence& operator=(const DebugSilence&) = delete;

 private:
  const RealGl& real_;
  const bool on_;
};

}  // namespace gluray::gl
