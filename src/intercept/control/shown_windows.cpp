#include "intercept/control/shown_windows.h"

#include "base/never_destroyed.h"
#include "intercept/control/link.h"
#include "intercept/session/guarded.h"
#include "intercept/windows/glx_windows.h"

#include <X11/Xlib.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <map>
#include <mutex>

namespace gluray::intercept {
namespace {

constexpr size_t kMaxShownWindows = 16;

struct Shown {
  std::mutex mutex;
  std::vector<ShownWindow> windows;          // last first
  std::map<const void*, uint32_t> surfaces;  // EGL surfaces and their X windows
  std::atomic<uintptr_t> last{0};            // drawable of the last swap; 0: query it again
  std::atomic<_XDisplay*> display{nullptr};  // its display

  static Shown& instance() {
    static NeverDestroyed<Shown> shown;
    return *shown;
  }
};

}  // namespace

namespace {

/// `name`: returns the window's id; called if the drawable differs from that of the last swap.
template <class Name>
void note(_XDisplay* display, uintptr_t drawable, const Name& name) noexcept {
  if (!mayBeControlled() || isForkedChild()) return;
  try {
    Shown& shown = Shown::instance();
    if (shown.last.load(std::memory_order_relaxed) == drawable &&
        shown.display.load(std::memory_order_relaxed) == display)
      return;
    const ShownWindow now = name();
    {
      const std::lock_guard lock(shown.mutex);
      shown.last = drawable, shown.display = display;
      if (now.window == 0) return;
      std::erase(shown.windows, now);
      if (shown.windows.size() >= kMaxShownWindows) shown.windows.pop_back();
      shown.windows.insert(shown.windows.begin(), now);
    }
    leaveFile(now);
  } catch (const std::exception&) {}  // out of memory: retried at the next swap
}

}  // namespace

void noteShown(_XDisplay* display, uintptr_t drawable) noexcept {
  note(display, drawable, [&] {
    return ShownWindow{DisplayString(display), static_cast<uint32_t>(windowOf(drawable))};
  });
}

void noteSurface(const void* surface, uint64_t window) noexcept {
  constexpr uint64_t kMaxXName = (uint64_t{1} << 29) - 1;  // X11, chapter 1: ids have at most 29 bits
  if (!surface || window == 0 || window > kMaxXName) return;
  try {
    Shown& shown = Shown::instance();
    const std::lock_guard lock(shown.mutex);
    shown.surfaces[surface] = static_cast<uint32_t>(window);
  } catch (const std::exception&) {}  // out of memory: the window stays unknown
}

void forgetSurface(const void* surface) noexcept {
  Shown& shown = Shown::instance();
  const std::lock_guard lock(shown.mutex);
  shown.surfaces.erase(surface);
  if (shown.last == reinterpret_cast<uintptr_t>(surface)) shown.last = 0;  // its address may be reused
}

void noteShownSurface(const void* surface) noexcept {
  note(nullptr, reinterpret_cast<uintptr_t>(surface), [&] {
    Shown& shown = Shown::instance();
    const std::lock_guard lock(shown.mutex);
    const auto found = shown.surfaces.find(surface);
    return found == shown.surfaces.end() || !std::getenv("DISPLAY")
               ? ShownWindow{}
               : ShownWindow{std::getenv("DISPLAY"), found->second};
  });
}

std::vector<ShownWindow> shownWindows() {
  const std::lock_guard lock(Shown::instance().mutex);
  return Shown::instance().windows;
}

void forgetShown(const ShownWindow& window) {
  Shown& shown = Shown::instance();
  const std::lock_guard lock(shown.mutex);
  std::erase(shown.windows, window);
  shown.last = 0;  // a new drawable may get this id
}

}  // namespace gluray::intercept
