// Interface through which WindowFrames shows images without a swap of the back buffer, at once or traced
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

/// An image for a window that otherwise holds only a clear: misses, hits beyond the window depth `farthest`,
/// and the rest of the window have the clear colour. The image's lower left pixel is pixel image.x, image.y
/// of the window. Images with equal numbers are equal.
struct ShownImage {
  const Image& image;
  float farthest;
  uint64_t number;
  int threads = 0;  // threads that may work on it; 0: all
};
/// Shows an image. False: failed, the window is unchanged.
using ShowImage = std::function<bool(const ShownImage&)>;

/// A window whose images are shown without swaps by the real OpenGL, which sees the window's size only at
/// the first command after a swap. GL thread, context current.
class ShownWindow {
 public:
  virtual ~ShownWindow() = default;
  /// Asks for the window's size, as it is now, without waiting. Ignored while a question is open.
  virtual void askSize() noexcept = 0;
  /// Whether the size, asked for now or before, is another than that of the real OpenGL's buffers. False if
  /// the window is gone.
  virtual bool resized() noexcept = 0;
  /// Makes the real OpenGL swap, so that its buffers get the window's size, and shows the last image again.
  /// The back buffer is undefined afterwards.
  virtual void swap() noexcept = 0;
};

struct ShowTarget {
  ClearedTarget cleared;  // the window's clear
  float farthest = 1;     // ShownImage::farthest
  bool core = false;      // core profile
  ImageWish wish;
  const ShowImage& show;
};

/// The buffers of a WindowClear.
inline constexpr GLbitfield kClears = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
/// A clear of the window's whole back buffer, with the values at the time of the call.
struct WindowClear {
  GLbitfield mask = 0;
  std::array<GLfloat, 4> color{};
  GLdouble depth = 1;
  GLint stencil = 0;
};

/// How an image that is traced ahead is shown if the program does not ask for it in time.
struct Overdue {
  glm::ivec2 size{0};       // of the window in pixels
  GLenum buffer = GL_BACK;  // the window's buffer for which the image is
  std::chrono::steady_clock::duration after{};
  /// Shows the whole window: `size` pixels, RGBA8, bottom row first. Called on a thread of ours when the time
  /// `after` has passed and the image is traced; present() waits while it runs. Empty: never shown so.
  std::function<void(const uint32_t* pixels)> show;
};

struct AheadTarget {
  GLenum depthFunc = GL_LESS;
  std::optional<ClearedTarget> cleared = {};  // the window's clear, if it holds nothing else
  float farthest = 1;                         // with `cleared`: ShownImage::farthest
  Overdue overdue = {};
};

/// Opens the window that was swapped; null: not possible.
using OpenIdleWindow = std::function<std::shared_ptr<IdleWindow>()>;

/// The base class shows nothing.
class WindowPresenter {
 public:
  virtual ~WindowPresenter() = default;
  /// Traces `snapshot` and shows its image in the window; the back buffer stays as it is. Otherwise as
  /// Presenter::present(); not traced: nothing was shown.
  virtual PresentResult show(const RealGl&, const scene::SnapshotPtr&,
                             const ShowTarget& /*target*/) noexcept {
    return {};
  }
  /// Begins to trace `snapshot`, for the window's back buffer, while the program goes on. Next call present()
  /// with the same snapshot, or dropAhead(). Returns LagRefusal::none or why it does not. The snapshot must
  /// not change any more.
  virtual LagRefusal traceAhead(const RealGl&, const scene::SnapshotPtr&, const AheadTarget&) noexcept {
    return LagRefusal::failure;
  }
  /// Discards the image that is traced ahead.
  virtual void dropAhead() noexcept {}
  /// The frame is shown in the window that `open` opens: its images with light get better there on a thread
  /// of ours until stopRefining(), another frame, or any other call that traces. Without a window they are
  /// only remembered for reads; an empty `open` forgets them.
  virtual void refineWhileIdle(const OpenIdleWindow& /*open*/) noexcept {}
  virtual void stopRefining() noexcept {}
  /// Whether show() knows the pixels of this clear without reading them from the back buffer.
  virtual bool knowsClear(const ClearedTarget& /*cleared*/) const noexcept { return true; }
  /// Makes `clear` in the window's back buffer, whatever the current state, which stays as it is. Returns the
  /// program's error that was pending, if any.
  virtual GLenum clear(const RealGl&, const WindowClear& /*clear*/) noexcept { return GL_NO_ERROR; }
};

}  // namespace gluray::gl
