// What a framebuffer holds of the colour that it was cleared to. GL thread, context current.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/present/features.h"
#include "intercept/present/write_back/state_guard.h"

#include <array>
#include <cstdint>
#include <optional>

namespace gluray::present {

/// Of framebuffers of one format, each with eight bits a channel.
class ClearedColor {
 public:
  /// RGBA8, red in the lowest byte; none where it cannot be read. The framebuffer is bound for drawing.
  /// Errors that were pending are moved to `pending`. Read once a colour: the real OpenGL clears at once for
  /// it.
  std::optional<uint32_t> bits(const gl::RealGl& real, const Features& features,
                               const gl::ClearedTarget& cleared, PendingErrors& pending);

 private:
  std::optional<std::array<float, 4>> color_;  // of the last clear
  uint32_t bits_ = 0;
};

}  // namespace gluray::present
