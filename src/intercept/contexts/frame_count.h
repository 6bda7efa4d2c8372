// Counts the frames that the process ends. Any thread.
#pragma once
#include <cstdint>

namespace gluray::intercept {

/// Counts a frame that has ended, and advances the clock that `gluray explain` preloads.
void countFrame() noexcept;
/// Number of frames that have ended.
uint64_t framesEnded() noexcept;

}  // namespace gluray::intercept
