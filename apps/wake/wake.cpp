#include "wake/wake.h"

#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <system_error>
#include <thread>

namespace gluray {
namespace {

void expose(const std::string& display, unsigned long window) {
  xcb_connection_t* server = xcb_connect(display.c_str(), nullptr);
  if (!xcb_connection_has_error(server)) {
    constexpr uint8_t kExposures = 1;
    // Zeros: the whole window. Waits until the server has done it; what it answers does not matter.
    std::free(xcb_request_check(
        server, xcb_clear_area_checked(server, kExposures, static_cast<xcb_window_t>(window), 0, 0, 0, 0)));
  }
  xcb_disconnect(server);
}

}  // namespace

void wakeWindow(const std::string& display, unsigned long window) {
  // A thread of its own, which nobody waits for: xcb has no time limits.
  try {
    std::thread(expose, display, window).detach();
  } catch (const std::system_error&) {  // no more threads: the program sleeps on
  }
}

}  // namespace gluray
