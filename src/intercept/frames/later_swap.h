// Delayed swaps, made once the frame is traced (frame lag). GL threads.
#pragma once
#include "intercept/windows/real_swap.h"

namespace gluray::intercept {

/// Called instead of a swap of `drawable`. True: the swap will be made later. False: make it now.
bool swapsLater(_XDisplay* display, XId drawable, RealSwap swap) noexcept;
/// Call when a swap of the drawable returned or was delayed.
void noteSwap() noexcept;

}  // namespace gluray::intercept
