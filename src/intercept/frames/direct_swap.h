// Shows frames without a swap of the real OpenGL. On the thread in which the context is current.
#pragma once
#include "intercept/windows/real_swap.h"

#include <cstdint>

namespace gluray::intercept {

/// Call before a swap of `drawable` by `swap`. Returns true if the frame has been shown, so that the swap
/// must be skipped.
bool shownDirectly(_XDisplay* display, uintptr_t drawable, RealSwap swap) noexcept;

}  // namespace gluray::intercept
