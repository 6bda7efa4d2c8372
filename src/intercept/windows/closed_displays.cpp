#include "intercept/windows/closed_displays.h"

#include "base/never_destroyed.h"

#include <X11/Xlib.h>
#include <dlfcn.h>

#include <map>
#include <mutex>

namespace gluray::intercept {
namespace {

struct Displays {
  std::mutex mutex;
  std::map<Display*, Closed> open;

  static Displays& instance() {
    static NeverDestroyed<Displays> displays;
    return *displays;
  }
};

int closing(Display* display, XExtCodes*) {
  Displays& displays = Displays::instance();
  const std::lock_guard lock(displays.mutex);
  if (const auto it = displays.open.find(display); it != displays.open.end()) {
    *it->second = true;
    displays.open.erase(it);
  }
  return 0;
}

}  // namespace

Closed watchDisplay(Display* display) {
  using AddExtension = XExtCodes* (*)(Display*);
  using SetClose = int (*(*)(Display*, int, int (*)(Display*, XExtCodes*)))(Display*, XExtCodes*);
  static void* const library = dlopen("libX11.so.6", RTLD_LAZY | RTLD_LOCAL);
  static const auto add = reinterpret_cast<AddExtension>(library ? dlsym(library, "XAddExtension") : nullptr);
  static const auto set = reinterpret_cast<SetClose>(library ? dlsym(library, "XESetCloseDisplay") : nullptr);
  if (!add || !set) return nullptr;
  Displays& displays = Displays::instance();
  {
    const std::lock_guard lock(displays.mutex);
    if (const auto it = displays.open.find(display); it != displays.open.end()) return it->second;
  }
  const XExtCodes* codes = add(display);  // takes the connection's own lock
  if (!codes) return nullptr;
  set(display, codes->extension, closing);
  const std::lock_guard lock(displays.mutex);
  return displays.open.try_emplace(display, std::make_shared<std::atomic<bool>>(false)).first->second;
}

}  // namespace gluray::intercept
