// The interface through which WindowFrames shows images without a swap of the back buffer: at once, or traced
// while the program prepares its next frame. Implemented in intercept/present/. GL thread.
#pragma once
#include "base/idle_window.h"
#include "base/image.h"
#include "gl/batch/cleared_target.h"
#include "gl/batch/lag_refusal.h"
#include "gl/batch/present_result.h"
#include "gl/clock/image_wish.h"
#include "gl/real/real.h"
#include "scene/snapshot.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace gluray::gl {

/// An image for a window that otherwise contains only a clear. Misses, hits beyond the window depth
/// `farthest`, and the rest of the window have the clear colour. The image's lower left pixel is pixel
/// (image.x, image.y) of the window. Images with equal numbers are equal.
struct ShownImage {
  const Image& image;
  float farthest;
  uint64_t number;
  int threads = 0;  // threads that may work on it; 0: all
};
/// Shows an image. Returns false if that failed and the window is unchanged.
using ShowImage = std::function<bool(const ShownImage&)>;

/// A window whose images are shown without swaps by the real OpenGL. The real OpenGL updates its buffers to
/// the window's size only at the first command after a swap. GL thread, context current.
class ShownWindow {
 public:
  virtual ~ShownWindow() = default;
  /// Requests the window's current size without waiting. Ignored while a request is open.
  virtual void askSize() noexcept = 0;
  /// Whether the last requested size differs from the size of the real OpenGL's buffers. False if the window
  /// is gone.
  virtual bool resized() noexcept = 0;
  /// Makes the real OpenGL swap, so that its buffers get the window's size, and shows the last image again.
  /// Afterwards the back buffer is undefined.
  virtual void swap() noexcept = 0;
};

struct ShowTarget {
  ClearedTarget cleared;  // the window's clear
  float farthest = 1;     // ShownImage::farthest
  bool core = false;      // core profile
  ImageWish wish;
  const ShowImage& show;
};

/// The buffers that a WindowClear may clear.
inline constexpr GLbitfield kClears = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
/// A clear of the window's whole back buffer, with the clear values at the time of the call.
struct WindowClear {
  GLbitfield mask = 0;
  std::array<GLfloat, 4> color{};
  GLdouble depth = 1;
  GLint stencil = 0;
};

/// How an image that is traced ahead is shown if the program does not request it in time.
struct Overdue {
  glm::ivec2 size{0};       // of the window in pixels
  GLenum buffer = GL_BACK;  // the window's buffer that the image is for
  std::chrono::steady_clock::duration after{};
  /// Shows the whole window: `size` pixels, RGBA8, bottom row first. Called on a thread of GLuRay when the
  /// time `after` has passed and the image is traced; present() waits while it runs. Empty: the image is
  /// never shown in this way.
  std::function<void(const uint32_t* pixels)> show;
};

struct AheadTarget {
  GLenum depthFunc = GL_LESS;
  std::optional<ClearedTarget> cleared = {};  // the window's clear, if the window contains nothing else
  float farthest = 1;                         // with `cleared`: ShownImage::farthest
  Overdue overdue = {};
};

/// Opens the window that was swapped; returns null if that is not possible.
using OpenIdleWindow = std::function<std::shared_ptr<IdleWindow>()>;

/// The base class shows nothing.
class WindowPresenter {
 public:
  virtual ~WindowPresenter() = default;
  /// Traces `snapshot` and shows its image in the window; the back buffer is not changed. Otherwise like
  /// Presenter::present(). Outcome other than traced: nothing was shown.
  virtual PresentResult show(const RealGl&, const scene::SnapshotPtr&,
                             const ShowTarget& /*target*/) noexcept {
    return {};
  }
  /// Begins to trace `snapshot` for the window's back buffer while the program continues. The next call must
  /// be present() with the same snapshot, or dropAhead(). Returns LagRefusal::none, or why it does not trace.
  /// The snapshot must not change any more.
  virtual LagRefusal traceAhead(const RealGl&, const scene::SnapshotPtr&, const AheadTarget&) noexcept {
    return LagRefusal::failure;
  }
  /// Discards the image that is traced ahead.
  virtual void dropAhead() noexcept {}
  /// Reports that the frame is shown in the window that `open` opens. A thread of GLuRay refines its images
  /// with light there until stopRefining(), another frame, or any other call that traces. Without a window
  /// the images are only kept for reads. An empty `open` forgets them.
  virtual void refineWhileIdle(const OpenIdleWindow& /*open*/) noexcept {}
  virtual void stopRefining() noexcept {}
  /// Whether show() knows the pixels of this clear without reading them from the back buffer.
  virtual bool knowsClear(const ClearedTarget& /*cleared*/) const noexcept { return true; }
  /// Makes `clear` in the window's back buffer, whatever the current state, which it does not change. Returns
  /// the program's GL error that was pending, if any.
  virtual GLenum clear(const RealGl&, const WindowClear& /*clear*/) noexcept { return GL_NO_ERROR; }
};

}  // namespace gluray::gl
