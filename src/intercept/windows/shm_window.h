// Shows images in an X window without OpenGL, through shared memory (MIT-SHM). Called on the thread in which
// the window's context is current.
#pragma once
#include "gl/batch/presenter.h"
#include "intercept/window_systems/xcb.h"
#include "intercept/windows/closed_displays.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace gluray::intercept {

/// Writes the image into `pixels`: `size.x` x `size.y`, top row first, blue in the lowest byte.
void fillWindow(const gl::ShownImage& image, glm::ivec2 size, uint32_t* pixels);

class ShmWindow {
 public:
  /// Null if the drawable is not a window, if its pixels are not 32-bit words with eight bits each for red,
  /// green and blue, or if the server shares no memory with this process.
  static std::unique_ptr<ShmWindow> create(_XDisplay* display, uintptr_t drawable) noexcept;
  ~ShmWindow();
  /// Releases the server's resources, if the connection is known to be open and belongs to this process.
  void close() noexcept;
  ShmWindow(const ShmWindow&) = delete;
  ShmWindow& operator=(const ShmWindow&) = delete;

  bool isFor(_XDisplay* display, uintptr_t drawable) const {
    return display == display_ && drawable == window_;
  }
  /// Requests the window's current size without waiting, unless a request is open.
  void askSize() noexcept;
  /// The window's size in pixels: at the time of askSize(), or now if no request is open. {0, 0} if the
  /// window does not exist, or the last image could not be shown. Waits until the server has read the last
  /// image.
  glm::ivec2 size() noexcept;
  /// Shows an image in a window of that size. Returns false if memory runs out or the connection is lost.
  bool put(const gl::ShownImage& image, glm::ivec2 size) noexcept;
  /// Shows the last image again, with the same size.
  void putAgain() noexcept;

 private:
  ShmWindow(_XDisplay* display, xcb_connection_t* connection, xcb_window_t window, uint8_t depth)
      : display_(display),
        connection_(connection),
        window_(window),
        depth_(depth),
        closed_(watchDisplay(display)) {}
  bool isOpen() const { return !closed_ || !*closed_; }
  bool makeContext();
  bool reserve(size_t bytes);
  bool send(glm::ivec2 size);
  void release();
  bool succeeded(xcb_void_cookie_t cookie) const;

  _XDisplay* display_;
  xcb_connection_t* connection_;
  xcb_window_t window_;
  uint8_t depth_;
  uint32_t context_ = 0, segment_ = 0;  // X ids of the graphics context and the shared memory
  uint32_t* pixels_ = nullptr;
  size_t bytes_ = 0;
  uint64_t held_ = 0;  // id of the image in the shared memory; 0: none
  glm::ivec2 heldSize_{0};
  float heldFarthest_ = 0;
  bool sent_ = false, asked_ = false;  // an image, a size query; their requests:
  xcb_void_cookie_t put_{};
  xcb_get_geometry_cookie_t geometry_{};
  Closed closed_;
};

}  // namespace gluray::intercept
