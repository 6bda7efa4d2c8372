// Shows images in an X window over a separate connection, without the program's connection or OpenGL. Created
// by a GL thread, used by one thread at a time.
#pragma once
#include "base/idle_window.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace gluray::intercept {

class BackgroundWindow {
 public:
  /// Null if this server or window is not supported: no XCB, or no TrueColor visual with eight bits per
  /// channel and four bytes per pixel.
  static std::unique_ptr<BackgroundWindow> open(const std::string& display, uint32_t window);
  virtual ~BackgroundWindow() = default;
  /// Reads the visible pixels: RGBA8, bottom row first. Returns false if the window does not exist, is
  /// hidden, or is partly outside the screen.
  virtual bool read(WindowPixels& out) noexcept = 0;
  /// Shows `size` pixels, RGBA8, bottom row first, and waits for the server to finish. Returns false if the
  /// window does not exist or has another size.
  virtual bool paint(const uint32_t* pixels, glm::ivec2 size) noexcept = 0;
};

}  // namespace gluray::intercept
