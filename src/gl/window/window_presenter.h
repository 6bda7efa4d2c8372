// How pictures reach a window in other ways than by a swap of its back buffer: shown at once, or traced while
// the program prepares its next frame. Implemented in intercept/present/. GL thread.
#pragma once
#include "base/image.h"
#include "gl/batch/cleared_target.h"
#include "gl/batch/present_result.h"
#include "gl/real.h"
#include "scene/snapshot.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

namespace gluray::gl {

/// A picture for the window, which holds nothing else but what it was cleared to: misses have that colour,
/// and so has the rest of the window. Hits beyond the window depth `farthest` count as misses. The lower left
/// pixel is image.x, image.y of the window. Pictures of the same number are the same.
struct ShownPicture {
  const Image& image;
  float farthest;
  uint64_t number;
  int threads = 0;  // that may work on it; 0: all
};
/// Shows one. False where it could not: the window is as it was.
using ShowPicture = std::function<bool(const ShownPicture&)>;

struct ShowTarget {
  ClearedTarget cleared;  // the window
  float farthest = 1;
  bool core = false;      // core profile
  bool mayRepeat = true;  // as PresentTarget's
  const ShowPicture& show;
};

/// A clear of the window's whole back buffer, as it was asked for.
struct WindowClear {
  GLbitfield mask = 0;
  std::array<GLfloat, 4> color{};
  GLdouble depth = 1;
  GLint stencil = 0;
};

/// What becomes of a picture that is traced ahead and that nobody presents.
struct Overdue {
  glm::ivec2 size{0};       // of the window in pixels
  GLenum buffer = GL_BACK;  // of it, where the picture goes
  std::chrono::steady_clock::duration after{};
  /// Shows the whole window: `size` pixels, RGBA8, bottom row first. Called by a thread of ours, `after` that
  /// time or when it is traced, whichever is later; while it runs present() waits. Empty: it waits for ever.
  std::function<void(const uint32_t* pixels)> show;
};

struct AheadTarget {
  GLenum depthFunc = GL_LESS;
  std::optional<ClearedTarget> cleared = {};  // the window, where it holds nothing else
  float farthest = 1;                         // then, as ShownPicture's
  Overdue overdue = {};
};

enum class LagRefusal : uint8_t;

/// The base class shows nothing.
class WindowPresenter {
 public:
  virtual ~WindowPresenter() = default;
  /// Traces `snapshot` and has its picture shown in the place of what is in the back buffer, which stays as
  /// it is. Otherwise as Presenter::present(); not traced: nothing was shown.
  virtual PresentResult show(const RealGl&, const scene::SnapshotPtr&,
                             const ShowTarget& /*target*/) noexcept {
    return {};
  }
  /// Begins to trace `snapshot`, whose framebuffer is the window's back buffer, while the program goes on;
  /// the next present() shall be of it, or dropAhead(). Says why it does not, LagRefusal::none if it does.
  /// The snapshot is not changed any more.
  virtual LagRefusal traceAhead(const RealGl&, const scene::SnapshotPtr&, const AheadTarget&) noexcept;
  /// Nobody wants the picture that is traced ahead.
  virtual void dropAhead() noexcept {}
  /// Clears the window's back buffer as `clear` says, whatever the state. Returns an error of the program's
  /// that was pending.
  virtual GLenum clear(const RealGl&, const WindowClear& /*clear*/) noexcept { return GL_NO_ERROR; }
};

}  // namespace gluray::gl
