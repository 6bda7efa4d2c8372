// Shows images in an X window over its own connection, without the program's connection or OpenGL. Made by
// a GL thread, used by one thread at a time.
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
  /// The pixels that the user sees, RGBA8, bottom row first. False if the window is gone, hidden or partly
  /// outside the screen.
  virtual bool read(WindowPixels& out) noexcept = 0;
  /// Shows `size` pixels, RGBA8, bottom row first, and waits for the server to finish. False if the window is
  /// gone or has another size.
  virtual bool paint(const uint32_t* pixels, glm::ivec2 size) noexcept = 0;
};

}  // namespace gluray::intercept
