#include "intercept/windows/idle_window_of_context.h"

#include "base/never_destroyed.h"
#include "intercept/windows/background_window.h"
#include "intercept/windows/glx_windows.h"
#include "intercept/windows/window_images.h"

#include <X11/Xlib.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <map>
#include <mutex>

namespace gluray::intercept {
namespace {

/// The windows that are being refined, by name, and how often each has changed.
struct Watched {
  struct Window {
    int users = 0;
    uint64_t changes = 0;
    std::mutex painting;
  };
  std::mutex mutex;
  std::map<uintptr_t, Window> windows;
  std::atomic<int> count{0};

  static Watched& instance() {
    static NeverDestroyed<Watched> watched;
    return *watched;
  }
};

class XIdleWindow final : public IdleWindow {
 public:
  XIdleWindow(std::shared_ptr<BackgroundWindow> shown, uintptr_t name)
      : shown_(std::move(shown)), name_(name), watched_(Watched::instance()) {
    const std::lock_guard lock(watched_.mutex);
    window_ = &watched_.windows[name];
    ++window_->users, ++watched_.count;
    changes_ = window_->changes;
  }
  ~XIdleWindow() override {
    const std::lock_guard lock(watched_.mutex);
    --watched_.count;
    if (--window_->users == 0) watched_.windows.erase(name_);
  }

  bool read(WindowPixels& out) noexcept override {
    const std::lock_guard lock(window_->painting);
    return isCurrent() && shown_->read(out);
  }

  bool replace(const WindowPixels& now, const WindowPixels& next) noexcept override {
    constexpr uint32_t kColors = 0xffffff;
    const std::lock_guard lock(window_->painting);
    if (!isCurrent() || !shown_->read(seen_) || seen_.width != now.width || seen_.height != now.height)
      return false;
    const bool same = std::equal(now.colors.begin(), now.colors.end(), seen_.colors.begin(),
                                 [](uint32_t a, uint32_t b) { return ((a ^ b) & kColors) == 0; });
    if (!same || !shown_->paint(next.colors.data(), {next.width, next.height})) return false;
    keepPixels(next.colors.data(), {next.width, next.height});
    return true;
  }

 private:
  bool isCurrent() const { return window_->changes == changes_; }  // requires that `painting` is locked

  std::shared_ptr<BackgroundWindow> shown_;
  uintptr_t name_;
  Watched& watched_;
  Watched::Window* window_ = nullptr;
  uint64_t changes_ = 0;
  WindowPixels seen_;  // reused memory
};

}  // namespace

std::shared_ptr<IdleWindow> IdleWindowOfContext::open(_XDisplay* display, uintptr_t drawable) {
  const uintptr_t name = windowOf(drawable);
  if (display != display_ || name != name_) {
    display_ = display, name_ = name;
    window_ = BackgroundWindow::open(DisplayString(display), static_cast<uint32_t>(name));
  }
  return window_ ? std::make_shared<XIdleWindow>(window_, name) : nullptr;
}

void windowChanges(uintptr_t drawable) noexcept {
  Watched& watched = Watched::instance();
  if (watched.count == 0) return;
  try {
    const uintptr_t name = windowOf(drawable);
    const std::lock_guard lock(watched.mutex);
    const auto found = watched.windows.find(name);
    if (found == watched.windows.end()) return;
    const std::lock_guard painting(found->second.painting);
    ++found->second.changes;
  } catch (const std::exception&) {}
}

}  // namespace gluray::intercept
