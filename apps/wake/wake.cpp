#include "wake/wake.h"

#include <dlfcn.h>
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

/// The functions of libxcb, loaded when a window is to be woken: commands work where the library is missing.
struct Xcb {
  Xcb() {
    void* const library = dlopen("libxcb.so.1", RTLD_LAZY | RTLD_LOCAL);
    if (!library) return;
    find(library, "xcb_connect", connect);
    find(library, "xcb_disconnect", disconnect);
    find(library, "xcb_connection_has_error", failed);
    find(library, "xcb_get_geometry", askGeometry);
    find(library, "xcb_get_geometry_reply", geometry);
    find(library, "xcb_send_event_checked", sendEvent);
    find(library, "xcb_request_check", check);
  }

  template <class Function>
  void find(void* library, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(dlsym(library, name));
    complete = complete && function;
  }

  /// Whether all functions are there.
  explicit operator bool() const { return complete && connect; }

  decltype(xcb_connect)* connect = nullptr;
  decltype(xcb_disconnect)* disconnect = nullptr;
  decltype(xcb_connection_has_error)* failed = nullptr;
  decltype(xcb_get_geometry)* askGeometry = nullptr;
  decltype(xcb_get_geometry_reply)* geometry = nullptr;
  decltype(xcb_send_event_checked)* sendEvent = nullptr;
  decltype(xcb_request_check)* check = nullptr;

 private:
  bool complete = true;
};

const Xcb& xcb() {
  static const Xcb once;
  return once;
}

struct Disconnect {
  void operator()(xcb_connection_t* server) const { xcb().disconnect(server); }
};
using Server = std::unique_ptr<xcb_connection_t, Disconnect>;

/// Nothing is cleared: programs that do not draw at once keep what they show. Waits for the server, which may
/// have gone.
void expose(xcb_connection_t* server, xcb_window_t window) {
  union {
    xcb_expose_event_t event;
    char bytes[32];  // of every event
  } exposed{};
  exposed.event.response_type = XCB_EXPOSE;
  exposed.event.window = window;
  auto* size = xcb().geometry(server, xcb().askGeometry(server, window), nullptr);
  if (!size) return;
  exposed.event.width = size->width, exposed.event.height = size->height;
  std::free(size);
  const auto sent = xcb().sendEvent(server, /*propagate=*/0, window, XCB_EVENT_MASK_EXPOSURE, exposed.bytes);
  std::free(xcb().check(server, sent));
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
    Server server;
    std::string connected;
    while (auto window = take()) {
      if (!server || connected != window->display || xcb().failed(server.get())) {
        server.reset(xcb().connect(window->display.c_str(), nullptr));
        connected.swap(window->display);
      }
      if (!xcb().failed(server.get())) expose(server.get(), window->number);
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
  if (!xcb()) return false;
  const Server server(xcb().connect(display.c_str(), nullptr));
  return !xcb().failed(server.get());
}

void wakeWindow(const std::string& display, unsigned long window) {
  if (!xcb()) return;
  // A thread of its own, which nobody waits for: xcb has no time limits. What it uses outlives the process's
  // other objects.
  try {
    static auto& queue = *new WakeQueue;
    queue.add(display, static_cast<xcb_window_t>(window));
  } catch (const std::exception&) {  // no more threads or memory: the program sleeps on
  }
}

}  // namespace gluray
