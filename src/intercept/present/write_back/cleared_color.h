// The pixel value that a framebuffer holds after a clear. GL thread, context current.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/state/features.h"
#include "intercept/present/state/state_guard.h"

#include <array>
#include <cstdint>
#include <optional>

namespace gluray::present {

/// For framebuffers of one format with eight bits per channel.
class ClearedColor {
 public:
  /// RGBA8, red in the lowest byte; none if it cannot be read. Requires the framebuffer bound for drawing
  /// and, unless knows(), its clear made. Moves pending errors to `pending`. Reads once per colour, because a
  /// read makes the real OpenGL perform the clear.
  std::optional<uint32_t> bits(const gl::RealGl& real, const Features& features,
                               const gl::ClearedTarget& cleared, PendingErrors& pending);

  /// Whether bits() reads nothing.
  bool knows(const gl::ClearedTarget& cleared) const { return color_ == cleared.color; }

 private:
  std::optional<std::array<float, 4>> color_;  // of the last clear
  uint32_t bits_ = 0;
};

}  // namespace gluray::present
