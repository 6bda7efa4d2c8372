// Tests by drawing whether the real OpenGL's blending replaces the destination completely if alpha is 1 up to
// rounding. One per context. GL thread, context current; restores all state.
#pragma once
#include "gl/real/real.h"
#include "intercept/present/state/features.h"

#include <optional>

namespace gluray::present {

class BlendingTrial {
 public:
  /// FramebufferReader::replacesColors(). Draws at the first call.
  bool passes(const gl::RealGl& real, const Features& features);

 private:
  std::optional<bool> passes_;
};

}  // namespace gluray::present
