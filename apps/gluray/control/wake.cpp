#include "control/wake.h"

#include <xcb/xcb.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <future>
#include <memory>
#include <thread>

namespace gluray::launcher {
namespace {

constexpr std::chrono::milliseconds kMostTime{500};

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
  // A thread of its own: xcb has no time limits. One whose server does not answer is left behind.
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> end = done->get_future();
  std::thread([done, display, window] {
    expose(display, window);
    done->set_value();
  }).detach();
  end.wait_for(kMostTime);
}

}  // namespace gluray::launcher
