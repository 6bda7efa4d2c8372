// Frame lag of GLX windows: delays swaps until the frame is traced. GL threads.
#pragma once
#include "gl/window/lagged_frame.h"
#include "settings/settings.h"

#include <array>
#include <cstdint>
#include <memory>

struct _XDisplay;  // Xlib's Display, without its header's macros

namespace gluray::intercept {

using XId = unsigned long;
using RealSwap = void (*)(_XDisplay*, XId drawable);

/// State of one context's frame lag between frames.
class Lag;
struct LagDeleter {
  void operator()(Lag* lag) const;
};
using LagPtr = std::unique_ptr<Lag, LagDeleter>;

/// Called instead of a swap of `drawable`. True: the swap will be made later. False: make it now.
bool swapsLater(_XDisplay* display, XId drawable, RealSwap swap) noexcept;
/// Call when a swap of the drawable returned or was delayed.
void noteSwap() noexcept;
/// Disables lag for the process: the program waits for swap events, so no swap may come late.
void neverLag() noexcept;

/// Counts of the process's frames.
struct LagCounts {
  uint64_t later = 0, shownByUs = 0;  // delayed; of these shown over our own connection
  std::array<uint64_t, gl::kLagRefusals> because{};
};
LagCounts lagCounts() noexcept;

}  // namespace gluray::intercept
