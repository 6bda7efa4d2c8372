// Shows frames without a swap of the real OpenGL. On the thread in which the context is current.
#pragma once
#include "intercept/windows/real_swap.h"

#include <cstdint>

namespace gluray::intercept {

/// Call before a swap of `drawable` by `swap`. True: the frame has been shown; skip the swap.
bool shownDirectly(_XDisplay* display, uintptr_t drawable, RealSwap swap) noexcept;

}  // namespace gluray::intercept
