#include "intercept/window_systems/drawable_size.h"

#include "intercept/window_systems/xcb.h"

#include <cstdint>

namespace gluray::intercept {
namespace {

/// Size of X windows and pixmaps.
glm::ivec2 sizeOfX(xcb_connection_t* connection, uint32_t drawable) {
  if (!xcb().askGeometry || !xcb().geometry) return glm::ivec2(0);
  const auto reply = replyTo(xcb().geometry, connection, xcb().askGeometry(connection, drawable));
  return reply ? glm::ivec2(reply->width, reply->height) : glm::ivec2(0);
}

/// Size of windows, pixmaps and pbuffers that have only a GLX name (GLX 1.4, 3.3.4 to 3.3.6).
glm::ivec2 sizeOfGlx(xcb_connection_t* connection, uint32_t drawable) {
  if (!xcb().askAttributes || !xcb().attributes || !xcb().list) return glm::ivec2(0);
  const auto reply = replyTo(xcb().attributes, connection, xcb().askAttributes(connection, drawable));
  glm::ivec2 size(0);
  if (!reply) return size;
  const uint32_t* pair = xcb().list(reply.get());
  for (uint32_t i = 0; i < reply->num_attribs; ++i, pair += 2) {
    if (pair[0] == GLX_WIDTH) size.x = static_cast<int>(pair[1]);
    if (pair[0] == GLX_HEIGHT) size.y = static_cast<int>(pair[1]);
  }
  return size;
}

}  // namespace

glm::ivec2 drawableSize(Display* display, GLXDrawable drawable) noexcept {
  if (!display || !drawable || !xcb().connectionOf) return glm::ivec2(0);
  xcb_connection_t* const connection = xcb().connectionOf(display);
  if (!connection) return glm::ivec2(0);
  const auto name = static_cast<uint32_t>(drawable);
  const glm::ivec2 size = sizeOfX(connection, name);
  return size.x > 0 ? size : sizeOfGlx(connection, name);
}

bool isMapped(Display* display, XID window) noexcept {
  if (!display || !window || !xcb().connectionOf || !xcb().askWindow || !xcb().window) return false;
  xcb_connection_t* const connection = xcb().connectionOf(display);
  if (!connection) return false;
  const auto reply =
      replyTo(xcb().window, connection, xcb().askWindow(connection, static_cast<uint32_t>(window)));
  return reply && reply->map_state != XCB_MAP_STATE_UNMAPPED;
}

}  // namespace gluray::intercept
