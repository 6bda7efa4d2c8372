// Looks at another program's window: its image, and a polite request to close.
#pragma once
#include "bench/data/png.h"

#include <memory>
#include <optional>
#include <string>

namespace gluray::bench {

/// The first mapped window, in stacking order, whose class or instance name is `name`.
class XWindow {
 public:
  /// Throws std::runtime_error without a display.
  explicit XWindow(std::string name);
  ~XWindow();
  XWindow(const XWindow&) = delete;
  XWindow& operator=(const XWindow&) = delete;

  /// window.
  /// The window's content, if it is on the screen and 24 or 32 bits deep; nothing if there is no such window.
  /// window.
  std::optional<RgbImage> grab();
  /// Asks the window to close as a window manager's button does; false where there is no such window.
  bool close();

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace gluray::bench
