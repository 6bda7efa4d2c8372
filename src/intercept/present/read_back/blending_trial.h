// Whether the real OpenGL's blending leaves nothing of what was below where alpha is 1 but for rounding:
// found out by drawing. One per context. GL thread, context current; restores all state.
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
