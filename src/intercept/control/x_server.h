// Queries about the program's windows to X servers, over separate connections: on the program's connection,
// an error could call the program's handler and end the program. Control thread.
#pragma once
#include "intercept/control/shown_windows.h"

#include <glm/glm.hpp>

#include <map>
#include <string>

struct xcb_connection_t;

namespace gluray::intercept {

class XServers {
 public:
  XServers() = default;
  ~XServers();
  XServers(const XServers&) = delete;
  XServers& operator=(const XServers&) = delete;

  /// Width and height in pixels; {0, 0} if the window does not exist.
  glm::ivec2 sizeOf(const ShownWindow& window);
  /// Sends the program an Expose event for the whole window. Returns false if the window does not exist or
  /// this is not supported.
  bool expose(const ShownWindow& window);
  /// Tells the program that the window has its present width, or one pixel more. Some toolkits show only a
  /// cached image when they are exposed, and redraw when a size changes. Returns false as expose() does.
  bool tellSize(const ShownWindow& window, bool wider);
  /// Closes all connections.
  void close() noexcept;

 private:
  xcb_connection_t* connectionTo(const std::string& display);
  static bool arrived(xcb_connection_t* connection, const ShownWindow& window);
  static bool isTopLevel(xcb_connection_t* connection, uint32_t window, uint32_t root);
  std::map<std::string, xcb_connection_t*> connections_;  // null: no connection is possible
};

}  // namespace gluray::intercept
