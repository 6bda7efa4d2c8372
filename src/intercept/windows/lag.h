// Frame lag of GLX windows: the state that a context needs to show its frames later, and counts of such
// frames. GL threads.
#pragma once
#include "gl/window/lagged_frame.h"
#include "intercept/windows/closed_displays.h"
#include "intercept/windows/following_frames.h"
#include "intercept/windows/real_swap.h"
#include "intercept/windows/window_of_context.h"
#include "settings/settings.h"

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

namespace gluray::intercept {

class BackgroundWindow;

/// One context's frame lag between frames.
class Lag {
 public:
  FollowingFrames following;

  /// Prepares to show a frame of `drawable` later, by `swap` or in `shown`, which must outlive `window`.
  /// Returns the reason if that is impossible. `keep`: called before the swap, to keep the frame's image.
  gl::LagRefusal prepare(_XDisplay* display, XId drawable, RealSwap swap, LagMode mode,
                         WindowOfContext& shown, std::function<void()> keep, gl::LagWindow& window);

 private:
  void adopt(_XDisplay* display, XId drawable);

  _XDisplay* display_ = nullptr;
  XId drawable_ = 0;
  Closed closed_;
  std::shared_ptr<BackgroundWindow> background_;
};

/// Disables lag for the process, because the program waits for swap events, so that no swap may be late.
void neverLag() noexcept;
/// Whether neverLag() was called.
bool neverLags() noexcept;

/// Counts of the process's frames.
struct LagCounts {
  uint64_t later = 0, shownByUs = 0;  // delayed frames; those shown over our own connection
  std::array<uint64_t, gl::kLagRefusals> because{};
};
LagCounts lagCounts() noexcept;
/// Counts a frame that is shown later, or the reason why a frame is shown at once.
void countLag(gl::LagRefusal refusal) noexcept;

}  // namespace gluray::intercept
