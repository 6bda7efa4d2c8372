// Access to pixels whose traced images are refined: a window while its program is idle, or a framebuffer
// that a program reads. Made on a GL thread, implemented by intercept/; used by one thread at a time.
#pragma once
#include <cstdint>
#include <vector>

namespace gluray {

/// Pixels of a window: RGBA8, bottom row first. Alpha has no meaning.
struct WindowPixels {
  int width = 0, height = 0;
  std::vector<uint32_t> colors;
};

class IdleWindow {
 public:
  virtual ~IdleWindow() = default;
  /// Reads the visible pixels. Returns false if the window is gone or hidden, or the program has drawn a
  /// newer image.
  virtual bool read(WindowPixels& out) noexcept = 0;
  /// Shows `next` if the window still shows exactly `now`. Returns false if nothing was changed.
  virtual bool replace(const WindowPixels& now, const WindowPixels& next) noexcept = 0;
};

}  // namespace gluray
