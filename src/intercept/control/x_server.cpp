#include "intercept/control/x_server.h"

#include "intercept/window_systems/xcb.h"

#include <string_view>
#include <utility>

namespace gluray::intercept {

XServers::~XServers() { close(); }

void XServers::close() noexcept {
  for (const auto& [display, connection] : connections_)
    if (connection) xcb().disconnect(connection);
  connections_.clear();
}

xcb_connection_t* XServers::connectionTo(const std::string& display) {
  if (!xcb().connect || !xcb().sendEvent) return nullptr;
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

/// Waits until the server has executed the requests. It drops the requests of a connection that is closed
/// earlier.
bool XServers::arrived(xcb_connection_t* connection, const ShownWindow& window) {
  return replyTo(xcb().geometry, connection, xcb().askGeometry(connection, window.window)) != nullptr;
}

bool XServers::expose(const ShownWindow& window) {
  const glm::ivec2 size = sizeOf(window);
  xcb_connection_t* const connection = size.x > 0 ? connectionTo(window.display) : nullptr;
  if (!connection) return false;
  // The event is sent, not caused by clearing an area, so that programs that do not draw keep their image.
  union {
    xcb_expose_event_t event;
    char bytes[32];  // size of all events
  } exposed{};
  exposed.event.response_type = XCB_EXPOSE;
  exposed.event.window = window.window;
  exposed.event.width = static_cast<uint16_t>(size.x), exposed.event.height = static_cast<uint16_t>(size.y);
  xcb().sendEvent(connection, /*propagate=*/0, window.window, XCB_EVENT_MASK_EXPOSURE, exposed.bytes);
  return arrived(connection, window);
}

/// Whether the window is managed by a window manager, which leaves a property on it, or is a child of the
/// root window.
bool XServers::isTopLevel(xcb_connection_t* connection, uint32_t window, uint32_t root) {
  static constexpr std::string_view kManaged = "WM_STATE";
  const auto atom =
      replyTo(xcb().atom, connection,
              xcb().askAtom(connection, 1, static_cast<uint16_t>(kManaged.size()), kManaged.data()));
  if (atom && atom->atom != XCB_ATOM_NONE) {
    const auto state = replyTo(xcb().property, connection,
                               xcb().askProperty(connection, 0, window, atom->atom, XCB_ATOM_ANY, 0, 0));
    if (state && state->type != XCB_ATOM_NONE) return true;
  }
  const auto tree = replyTo(xcb().tree, connection, xcb().askTree(connection, window));
  return tree && tree->parent == root;
}

bool XServers::tellSize(const ShownWindow& window, bool wider) {
  xcb_connection_t* const connection = connectionTo(window.display);
  const bool able = xcb().askTree && xcb().tree && xcb().askPlace && xcb().place && xcb().askAtom &&
                    xcb().atom && xcb().askProperty && xcb().property;
  if (!connection || !able) return false;
  const auto geometry = replyTo(xcb().geometry, connection, xcb().askGeometry(connection, window.window));
  if (!geometry) return false;
  // As window managers do: the position of a top-level window is its position on the screen.
  glm::ivec2 at(geometry->x, geometry->y);
  if (isTopLevel(connection, window.window, geometry->root)) {
    const auto place =
        replyTo(xcb().place, connection, xcb().askPlace(connection, window.window, geometry->root, 0, 0));
    if (!place) return false;
    at = {place->dst_x, place->dst_y};
  }
  union {
    xcb_configure_notify_event_t event;
    char bytes[32];  // size of all events
  } told{};
  told.event.response_type = XCB_CONFIGURE_NOTIFY;
  told.event.event = told.event.window = window.window;
  told.event.x = static_cast<int16_t>(at.x), told.event.y = static_cast<int16_t>(at.y);
  told.event.width = static_cast<uint16_t>(geometry->width + (wider ? 1 : 0));
  told.event.height = geometry->height;
  told.event.border_width = geometry->border_width;
  xcb().sendEvent(connection, /*propagate=*/0, window.window, XCB_EVENT_MASK_STRUCTURE_NOTIFY, told.bytes);
  return arrived(connection, window);
}

}  // namespace gluray::intercept
