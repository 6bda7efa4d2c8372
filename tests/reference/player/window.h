// A window with a fresh OpenGL context for each scene.
#pragma once
#include "gl/real/real.h"

namespace gluray::player {

class Window {
 public:
  /// Ends the program with one line on stderr if there is no display or no suitable visual.
  Window(int width, int height);
  /// Makes a new double-buffered context with 24 bits of depth and a stencil current; the one before is
  /// destroyed.
  void freshContext();
  void swap();
  /// OpenGL as glXGetProcAddress gives it.
  const gl::RealGl& gl() const { return gl_; }

 private:
  void* display_ = nullptr;
  void* visual_ = nullptr;
  void* context_ = nullptr;
  unsigned long window_ = 0;
  gl::RealGl gl_;
};

}  // namespace gluray::player
