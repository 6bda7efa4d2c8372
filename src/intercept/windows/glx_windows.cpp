#include "intercept/windows/glx_windows.h"

#include "base/never_destroyed.h"
#include "intercept/session/guarded.h"

#include <map>
#include <mutex>

namespace gluray::intercept {
namespace {

struct Names {
  std::mutex mutex;
  std::map<uintptr_t, uintptr_t> windows;
};
Names& names() {
  static NeverDestroyed<Names> all;
  return *all;
}

}  // namespace

void glxWindowMade(uintptr_t name, uintptr_t window) noexcept {
  guarded("cannot remember a window", [&] {
    const std::lock_guard lock(names().mutex);
    names().windows[name] = window;
  });
}

void glxWindowGone(uintptr_t name) noexcept {
  const std::lock_guard lock(names().mutex);
  names().windows.erase(name);
}

uintptr_t windowOf(uintptr_t drawable) noexcept {
  const std::lock_guard lock(names().mutex);
  const auto known = names().windows.find(drawable);
  return known == names().windows.end() ? drawable : known->second;
}

}  // namespace gluray::intercept
