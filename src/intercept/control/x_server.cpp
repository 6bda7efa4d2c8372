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
  if (!xcb().connect || !xcb().clearArea || !xcb().flush) return nullptr;
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
  // Drawables that are no windows, and windows whose input only counts, have no area.
  if (sizeOf(window) == glm::ivec2(0)) return false;
  xcb_connection_t* const connection = connectionTo(window.display);
  if (!connection) return false;
  // Of an area of one pixel: programs draw all of it, and what the server clears is hardly seen.
  xcb().clearArea(connection, /*exposures=*/1, window.window, 0, 0, 1, 1);
  return xcb().flush(connection) > 0;
}

}  // namespace gluray::intercept
