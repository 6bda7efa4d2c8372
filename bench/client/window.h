// A GLX window for the benchmark's client, made with Xlib and libGL alone.
#pragma once
#include <memory>

namespace gluray::bench {

/// A mapped, double-buffered window with 24 bits of depth whose context is current in the calling thread.
class Window {
 public:
  /// Throws std::runtime_error with one clear line: no display, no GLX, no fitting visual, no context.
  explicit Window(int size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  /// Shows the back buffer and waits until all commands have been carried out.
  void swapAndFinish();
  /// Shows the back buffer and goes on.
  void swap();

 private:
  struct Handles;  // Xlib's types stay out of this header: its macros collide with other libraries' names
  std::unique_ptr<Handles> handles_;
};

}  // namespace gluray::bench
