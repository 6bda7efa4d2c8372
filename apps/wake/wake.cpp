#include "wake/wake.h"

#include <xcb/xcb.h>

#include <cstdint>
#include <cstdlib>
#include <deque>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace gluray {
namespace {

using Server = std::unique_ptr<xcb_connection_t, decltype(&xcb_disconnect)>;

/// Nothing is cleared: programs that do not draw at once keep what they show. Waits for the server, which may
/// have gone.
void expose(xcb_connection_t* server, xcb_window_t window) {
  union {
    xcb_expose_event_t event;
    char bytes[32];  // of every event
  } exposed{};
  exposed.event.response_type = XCB_EXPOSE;
  exposed.event.window = window;
  auto* size = xcb_get_geometry_reply(server, xcb_get_geometry(server, window), nullptr);
  if (!size) return;
  exposed.event.width = size->width, exposed.event.height = size->height;
  std::free(size);
  const auto sent =
      xcb_send_event_checked(server, /*propagate=*/0, window, XCB_EVENT_MASK_EXPOSURE, exposed.bytes);
  std::free(xcb_request_check(server, sent));
}

/// Windows that wait, and at most one thread that wakes them one after the other.
struct WakeQueue {
  struct Window {
    std::string display;
    xcb_window_t number;
  };
  static constexpr size_t kMax = 4096;

  void add(const std::string& display, xcb_window_t window) {
    const std::lock_guard lock(mutex);
    if (waiting.size() < kMax) waiting.push_back({display, window});
    if (running) return;
    std::thread([this] { work(); }).detach();
    running = true;
  }

  void work() noexcept {
    Server server(nullptr, xcb_disconnect);
    std::string connected;
    while (auto window = take()) {
      if (!server || connected != window->display || xcb_connection_has_error(server.get())) {
        server.reset(xcb_connect(window->display.c_str(), nullptr));
        connected.swap(window->display);
      }
      if (!xcb_connection_has_error(server.get())) expose(server.get(), window->number);
    }
  }

  std::optional<Window> take() {
    const std::lock_guard lock(mutex);
    running = !waiting.empty();
    if (!running) return std::nullopt;
    Window window = std::move(waiting.front());
    waiting.pop_front();
    return window;
  }

  std::mutex mutex;
  std::deque<Window> waiting;
  bool running = false;
};

}  // namespace

bool canReach(const std::string& display) {
  xcb_connection_t* server = xcb_connect(display.c_str(), nullptr);
  const bool there = !xcb_connection_has_error(server);
  xcb_disconnect(server);
  return there;
}

void wakeWindow(const std::string& display, unsigned long window) {
  // A thread of its own, which nobody waits for: xcb has no time limits. What it uses outlives the process's
  // other objects.
  try {
    static auto& queue = *new WakeQueue;
    queue.add(display, static_cast<xcb_window_t>(window));
  } catch (const std::exception&) {  // no more threads or memory: the program sleeps on
  }
}

}  // namespace gluray
