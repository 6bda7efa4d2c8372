// The end of a frame: counts it, keeps its image, draws the HUD. GL threads.
#pragma once
#include <cstdint>

namespace gluray::intercept {

/// Call once, before the first context is made: contexts then record what reports and hubs want.
void followContexts() noexcept;

/// Before a buffer swap of `drawable`: flushes pending draws, and keeps the frame's image if wanted.
void swapping(uintptr_t drawable) noexcept;
/// A buffer swap of `drawable` returned: if this thread draws into it, a frame has ended.
void swapped(uintptr_t drawable) noexcept;

}  // namespace gluray::intercept
