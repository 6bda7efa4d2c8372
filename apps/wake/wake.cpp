#include "wake/wake.h"

#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <system_error>
#include <thread>

namespace gluray {
namespace {

/// Nothing is cleared: programs that do not draw at once keep what they show. Waits for the server, which may
/// have gone.
void expose(const std::string& display, unsigned long window) {
  union {
    xcb_expose_event_t event;
    char bytes[32];  // of every event
  } exposed{};
  exposed.event.response_type = XCB_EXPOSE;
  exposed.event.window = static_cast<xcb_window_t>(window);
  xcb_connection_t* server = xcb_connect(display.c_str(), nullptr);
  if (!xcb_connection_has_error(server)) {
    auto* size = xcb_get_geometry_reply(server, xcb_get_geometry(server, exposed.event.window), nullptr);
    if (size) {
      exposed.event.width = size->width, exposed.event.height = size->height;
      const auto sent = xcb_send_event_checked(server, /*propagate=*/0, exposed.event.window,
                                               XCB_EVENT_MASK_EXPOSURE, exposed.bytes);
      std::free(xcb_request_check(server, sent));
    }
    std::free(size);
  }
  xcb_disconnect(server);
}

}  // namespace

bool canReach(const std::string& display) {
  xcb_connection_t* server = xcb_connect(display.c_str(), nullptr);
  const bool there = !xcb_connection_has_error(server);
  xcb_disconnect(server);
  return there;
}

void wakeWindow(const std::string& display, unsigned long window) {
  // A thread of its own, which nobody waits for: xcb has no time limits.
  try {
    std::thread(expose, display, window).detach();
  } catch (const std::system_error&) {  // no more threads: the program sleeps on
  }
}

}  // namespace gluray
