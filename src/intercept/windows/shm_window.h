// Pictures shown in a window of the X server without OpenGL: put there from memory that the server shares.
// The thread that the window's context is current in.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/window_systems/xcb.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace gluray::intercept {

/// Fills `pixels`, `size.x` x `size.y` of them, upper row first, blue in the lowest byte, with the picture.
void fillWindow(const gl::ShownPicture& picture, glm::ivec2 size, uint32_t* pixels);

class ShmWindow {
 public:
  /// Null where the drawable is no window, has other pixels than eight bits of red, green and blue in 32, or
  /// the server shares no memory with this process.
  static std::unique_ptr<ShmWindow> create(_XDisplay* display, uintptr_t drawable) noexcept;
  ~ShmWindow();
  /// Gives the server back what it holds. The display is open.
  void close() noexcept;
  ShmWindow(const ShmWindow&) = delete;
  ShmWindow& operator=(const ShmWindow&) = delete;

  bool isFor(_XDisplay* display, uintptr_t drawable) const {
    return display == display_ && drawable == window_;
  }
  /// The window's size in pixels. {0, 0}: it is gone, or the last picture could not be shown. Waits until the
  /// server has taken the last picture.
  glm::ivec2 size() noexcept;
  /// Shows a picture; size() was asked before. False: without memory, or where the connection is lost.
  bool put(const gl::ShownPicture& picture) noexcept;

 private:
  ShmWindow(_XDisplay* display, xcb_connection_t* connection, xcb_window_t window, uint8_t depth)
      : display_(display), connection_(connection), window_(window), depth_(depth) {}
  bool makeContext();
  bool reserve(size_t bytes);
  void release();
  bool succeeded(xcb_void_cookie_t cookie) const;

  _XDisplay* display_;
  xcb_connection_t* connection_;
  xcb_window_t window_;
  uint8_t depth_;
  uint32_t context_ = 0, segment_ = 0;  // names of the graphics context and of the memory
  uint32_t* pixels_ = nullptr;
  size_t bytes_ = 0;
  glm::ivec2 size_{0};
  uint64_t held_ = 0;  // number of the picture that the memory holds; 0: none
  glm::ivec2 heldSize_{0};
  float heldFarthest_ = 0;
  bool asked_ = false;  // a picture is on its way, and after it this question:
  xcb_void_cookie_t put_{};
  xcb_get_geometry_cookie_t geometry_{};
};

}  // namespace gluray::intercept
