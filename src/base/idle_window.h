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
  /// The pixels that are seen. False: it is gone, hidden, or the program has drawn something newer.
  virtual bool read(WindowPixels& out) noexcept = 0;
  /// Shows `next` if the window still shows `now`, to the bit. False: nothing was changed.
  virtual bool replace(const WindowPixels& now, const WindowPixels& next) noexcept = 0;
};

}  // namespace gluray
