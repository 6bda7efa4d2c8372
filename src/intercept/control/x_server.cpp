#include "intercept/control/x_server.h"

#include "intercept/window_systems/xcb.h"

#include <utility>

namespace gluray::intercept {

XServers::~XServers() { close(); }

void XServers::close() noexcept {
  for (const auto& [display, connection] : connections_)
    if (connection) xcb().disconnect(connection);
  connections_.clear();
}

xcb_connection_t* XServers::connectionTo(const std::string& display) {
  if (!xcb().connect || !xcb().sendEvent || !xcb().flush) return nullptr;
  xcb_connection_t*& connection = connections_[display];
  if (connection && xcb().failed(connection)) xcb().disconnect(std::exchange(connection, nullptr));
  if (!connection) connection = xcb().connect(display.c_str(), nullptr);
  if (connection && xcb().failed(connection)) xcb().disconnect(std::exchange(connection, nullptr));
  return connection;
}

glm::ivec2 XServers::sizeOf(const ShownWindow& window) {
  xcb_connection_t* const connection = connectionTo(window.display);
  if (!connection) return {0, 0};
  const auto geometry = replyTo(xcb().geometry, connection, xcb().askGeometry(connection, window.window));
  return geometry ? glm::ivec2(geometry->width, geometry->height) : glm::ivec2(0);
}

bool XServers::expose(const ShownWindow& window) {
  const glm::ivec2 size = sizeOf(window);
  xcb_connection_t* const connection = size.x > 0 ? connectionTo(window.display) : nullptr;
  if (!connection) return false;
  // Sent, not caused by clearing an area: programs that do not draw keep what they show.
  union {
    xcb_expose_event_t event;
    char bytes[32];  // of every event
  } exposed{};
  exposed.event.response_type = XCB_EXPOSE;
  exposed.event.window = window.window;
  exposed.event.width = static_cast<uint16_t>(size.x), exposed.event.height = static_cast<uint16_t>(size.y);
  xcb().sendEvent(connection, /*propagate=*/0, window.window, XCB_EVENT_MASK_EXPOSURE, exposed.bytes);
  return xcb().flush(connection) > 0;
}

}  // namespace gluray::intercept
