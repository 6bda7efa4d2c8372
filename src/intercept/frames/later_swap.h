// Delayed swaps, which are made when the frame is traced (frame lag). GL threads.
#pragma once
#include "intercept/windows/real_swap.h"

namespace gluray::intercept {

/// Called instead of a swap of `drawable`. Returns true if the swap will be made later, false if it must be
/// made now.
bool swapsLater(_XDisplay* display, XId drawable, RealSwap swap) noexcept;
/// Call when a swap of the drawable has returned or was delayed.
void noteSwap() noexcept;

}  // namespace gluray::intercept
