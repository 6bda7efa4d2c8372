#include "intercept/windows/lag.h"

#include "base/timeline.h"
#include "intercept/window_systems/drawable_size.h"
#include "intercept/window_systems/real_functions.h"
#include "intercept/windows/background_window.h"
#include "intercept/windows/glx_windows.h"
#include "intercept/windows/idle_window_of_context.h"
#include "intercept/windows/window_images.h"

#include <GL/glx.h>

#include <atomic>
#include <chrono>
#include <utility>

namespace gluray::intercept {

using gl::LagRefusal;

namespace {

using namespace std::chrono_literals;
constexpr auto kOverdue = 25ms;  // time after a swap without a call by the program until we show the frame

std::atomic<bool> g_never{false};
std::atomic<uint64_t> g_later{0}, g_shownByUs{0};
std::array<std::atomic<uint64_t>, gl::kLagRefusals> g_because{};

}  // namespace

LagRefusal Lag::prepare(Display* display, GLXDrawable drawable, RealSwap swap, LagMode mode,
                        WindowOfContext& shown, std::function<void()> keep, gl::LagWindow& window) {
  if (display != display_ || drawable != drawable_) adopt(display, drawable);
  if (!closed_ || (mode == LagMode::automatic && !background_)) return LagRefusal::window;
  const glm::ivec2 size = drawableSize(display, drawable);
  if (size.x <= 0) return LagRefusal::window;
  window.stands = [=, closed = closed_] { return !*closed && drawableSize(display, drawable).x > 0; };
  window.swap = [=, &shown, keep = std::move(keep)] {
    const Outermost nested;
    keep();
    const timeline::Span span("swap");
    windowChanges(drawable);
    swap(display, drawable);
    shown.swapped = {0, 0};  // the next command finds out the size
  };
  window.overdue.size = size;
  window.show = [=, &shown](const gl::ShownImage& image) {
    ShmWindow* const put = shmWindowFor(display, drawable, shown);
    if (!put) return false;
    const glm::ivec2 now = put->size();
    if (!shown.isKnown(now) || !put->put(image, now)) return false;
    keepShownImage(image, now, ShownFrame::later);
    return true;
  };
  if (!background_) return LagRefusal::none;
  window.overdue.after = kOverdue;
  window.overdue.show = [background = background_, size](const uint32_t* pixels) {
    if (!background->paint(pixels, size)) return;
    ++g_shownByUs;
    keepPixels(pixels, size);
  };
  return LagRefusal::none;
}

void Lag::adopt(Display* display, GLXDrawable drawable) {
  display_ = display, drawable_ = drawable;
  closed_ = watchDisplay(display);
  background_ = BackgroundWindow::open(DisplayString(display), static_cast<uint32_t>(windowOf(drawable)));
}

void neverLag() noexcept { g_never = true; }

bool neverLags() noexcept { return g_never; }

LagCounts lagCounts() noexcept {
  LagCounts counts{g_later, g_shownByUs, {}};
  for (size_t i = 1; i < g_because.size(); ++i) counts.because.at(i) = g_because.at(i);
  return counts;
}

void countLag(LagRefusal refusal) noexcept {
  if (refusal == LagRefusal::none)
    ++g_later;
  else
    ++g_because.at(static_cast<size_t>(refusal));
}

}  // namespace gluray::intercept
