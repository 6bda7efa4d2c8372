// X server queries about the program's windows, over separate connections: on the program's connection, an
// error could call the program's handler and end the program. Control thread.
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

  /// Width and height in pixels; {0, 0}: it is gone.
  glm::ivec2 sizeOf(const ShownWindow& window);
  /// Sends the program an Expose event of the whole window. False: it is gone, or not supported.
  bool expose(const ShownWindow& window);
  /// Tells the program that the window has the width that it has, or one pixel more. Toolkits that show again
  /// what they drew when they are exposed draw anew when a size changes. False: as above.
  bool tellSize(const ShownWindow& window, bool wider);
  /// Closes all connections.
  void close() noexcept;

 private:
  xcb_connection_t* connectionTo(const std::string& display);
  static bool arrived(xcb_connection_t* connection, const ShownWindow& window);
  static bool isTopLevel(xcb_connection_t* connection, uint32_t window, uint32_t root);
  std::map<std::string, xcb_connection_t*> connections_;  // null: none is possible
};

}  // namespace gluray::intercept
