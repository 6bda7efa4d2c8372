// Puts pictures into a window of X over a connection of its own: neither the program's connection nor its
// OpenGL takes part. Made by a GL thread, used by one thread at a time.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <string>

namespace gluray::intercept {

class BackgroundWindow {
 public:
  /// Null where this server or this window cannot be painted: no XCB, no TrueColor of eight bits a channel in
  /// four bytes a pixel.
  static std::unique_ptr<BackgroundWindow> open(const std::string& display, uint32_t window);
  virtual ~BackgroundWindow() = default;
  /// Shows `size` pixels, RGBA8, bottom row first, and waits until the server has done it. False where the
  /// window is gone or of another size.
  virtual bool paint(const uint32_t* pixels, glm::ivec2 size) noexcept = 0;
};

}  // namespace gluray::intercept
