// Frame lag of GLX windows: swaps that are made later, when the frame is traced. GL threads.
#pragma once
#include "gl/window/lagged_frame.h"
#include "settings/settings.h"

#include <array>
#include <cstdint>
#include <memory>

struct _XDisplay;  // Xlib's Display: its macros stay out of here

namespace gluray::intercept {

using XId = unsigned long;
using RealSwap = void (*)(_XDisplay*, XId drawable);

/// What one context's lag needs between frames.
class Lag;
struct LagDeleter {
  void operator()(Lag* lag) const;
};
using LagPtr = std::unique_ptr<Lag, LagDeleter>;

/// In place of a swap of `drawable`: true where it will be made later; otherwise it is to be made now.
bool swapsLater(_XDisplay* display, XId drawable, RealSwap swap) noexcept;
/// A swap of the drawable returned, or will be made later.
void noteSwap() noexcept;
/// The program waits for swaps by their events: none may come late from now on.
void neverLag() noexcept;

/// What the process's frames came to.
struct LagCounts {
  uint64_t later = 0, shownByUs = 0;  // of those later: by our own connection
  std::array<uint64_t, gl::kLagRefusals> because{};
};
LagCounts lagCounts() noexcept;

}  // namespace gluray::intercept
