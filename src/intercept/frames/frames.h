// The end of a frame: counts it, keeps its image, draws the HUD. GL threads.
#pragma once
#include <cstdint>

namespace gluray::intercept {

/// Call once, before the first context is created: contexts then record what reports and hubs need.
void followContexts() noexcept;

/// Call before a buffer swap of `drawable`: flushes pending draws, and keeps the frame's image if it is
/// requested.
void swapping(uintptr_t drawable) noexcept;
/// Call after a buffer swap of `drawable`: if this thread draws into it, a frame has ended.
void swapped(uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
