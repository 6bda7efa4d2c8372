// Catches GLuRay's own failures and decides how much the real OpenGL draws after each of them: a draw, some
// frames, or all that follows. A part of each Context, GL thread.
#pragma once
#include "base/growing_interval.h"
#include "gl/basics/reasons.h"
#include "scene/failure.h"

#include <exception>
#include <functional>
#include <type_traits>
#include <utility>

namespace gluray::gl {

class Failsafe {
 public:
  /// `drawHeld` gives pending draws to the real OpenGL. It may throw.
  explicit Failsafe(std::function<void()> drawHeld) : drawHeld_(std::move(drawHeld)) {}

  /// Whether the real OpenGL makes every draw at present, for good or until a pause ends.
  bool aside() const { return gone_ || pause_ > 0; }
  /// Whether the real OpenGL makes every draw for good.
  bool gone() const { return gone_; }
  /// The reason to report for draws that are rasterised while aside() holds.
  Reason reason() const { return gone_ ? Reason::failure : Reason::shortage; }

  /// Reports a failure; `why` is one line for the log. Loss::draws changes nothing: the caller leaves the
  /// draws concerned to the real OpenGL. Loss::frames pauses tracing until depth has been cleared once; each
  /// further failure doubles the pause, up to 1,024 clears. Loss::tracing ends tracing for good. Loss::frames
  /// and Loss::tracing give pending draws to the real OpenGL, and each logs one warning, once.
  void fail(scene::Loss loss, const char* why) noexcept;
  /// Call after each glClear of depth: pauses are counted in these clears.
  void depthCleared() noexcept;

  /// Runs `body` and returns its result. If it throws, calls fail() and returns a default value.
  template <class F>
  auto protect(F&& body) noexcept -> decltype(body());
  /// Runs `body` as protect() does, and once more if it throws: by then the real OpenGL has drawn the failed
  /// capture, and memory may be free again.
  template <class F>
  void insist(F&& body) noexcept;
  /// Runs `trace`, which adds a draw to the batch or returns why it cannot. If it throws, calls fail() and
  /// returns the reason, so that the caller rasterises the draw.
  template <class F>
  Reason attempt(F&& trace);

 private:
  std::function<void()> drawHeld_;
  bool gone_ = false;
  bool told_ = false;                     // the first pause was logged
  int pause_ = 0;                         // clears of depth until tracing resumes; 0: no pause
  int since_ = 0;                         // clears of depth since the last pause
  GrowingInterval<int> pauses_{1, 1024};  // their lengths, in clears of depth
};

template <class F>
auto Failsafe::protect(F&& body) noexcept -> decltype(body()) {
  try {
    return body();
  } catch (const std::exception& e) { fail(scene::lossOf(e), e.what()); } catch (...) {
    fail(scene::Loss::tracing, "unknown error");
  }
  if constexpr (!std::is_void_v<decltype(body())>) return {};
}

template <class F>
void Failsafe::insist(F&& body) noexcept {
  bool done = false;
  const auto once = [&] { body(), done = true; };
  protect(once);
  if (!done) protect(once);
}

template <class F>
Reason Failsafe::attempt(F&& trace) {
  try {
    return trace();
  } catch (const std::exception& e) {
    const scene::Loss loss = scene::lossOf(e);
    if (loss == scene::Loss::draws) return Reason::untraceable;
    fail(loss, e.what());
  }
  return reason();
}

}  // namespace gluray::gl
