#include "intercept/control/shown_windows.h"

#include "intercept/contexts.h"
#include "intercept/control/link.h"
#include "intercept/windows/present_without_swap.h"

#include <X11/Xlib.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

namespace gluray::intercept {
namespace {

constexpr size_t kMostShown = 16;

/// Never destroyed: programs swap while they exit.
struct Shown {
  std::mutex mutex;
  std::vector<ShownWindow> windows;          // last first
  std::atomic<uintptr_t> last{0};            // drawable of the last swap; 0: ask again
  std::atomic<_XDisplay*> display{nullptr};  // its display

  static Shown& instance() {
    static auto* const shown = new Shown;
    return *shown;
  }
};

}  // namespace

void noteShown(_XDisplay* display, uintptr_t drawable) noexcept {
  if (!mayBeControlled() || isForkedChild()) return;
  try {
    Shown& shown = Shown::instance();
    if (shown.last.load(std::memory_order_relaxed) == drawable &&
        shown.display.load(std::memory_order_relaxed) == display)
      return;
    ShownWindow now{DisplayString(display), static_cast<uint32_t>(windowOf(drawable))};
    {
      const std::lock_guard lock(shown.mutex);
      std::erase(shown.windows, now);
      if (shown.windows.size() >= kMostShown) shown.windows.pop_back();
      shown.windows.insert(shown.windows.begin(), now);
      shown.last = drawable, shown.display = display;
    }
    leaveFile(now);
  } catch (const std::exception&) {}  // out of memory: the next swap
}

std::vector<ShownWindow> shownWindows() {
  const std::lock_guard lock(Shown::instance().mutex);
  return Shown::instance().windows;
}

void forgetShown(const ShownWindow& window) {
  Shown& shown = Shown::instance();
  const std::lock_guard lock(shown.mutex);
  std::erase(shown.windows, window);
  shown.last = 0;  // a drawable of this name may be made anew
}

}  // namespace gluray::intercept
