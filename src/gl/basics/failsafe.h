// Catches our own failures and decides how much of the host program's frames the real OpenGL draws after
// each: a draw, some frames, or all that follows. A part of each Context, GL thread.
#pragma once
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

  /// Whether the real OpenGL makes every draw now: for good, or until a pause ends.
  bool aside() const { return gone_ || pause_ > 0; }
  /// Whether it does so for good.
  bool gone() const { return gone_; }
  /// Why draws are rasterised while aside().
  Reason reason() const { return gone_ ? Reason::failure : Reason::shortage; }

  /// A failure, and `why` as one line. Loss::draws changes nothing: the caller leaves the draws concerned to
  /// the real OpenGL. Loss::frames pauses tracing until depth has been cleared once, and twice as often
  /// after each further failure (at most 1,024 times). Loss::tracing ends it. The last two give pending draws
  /// to the real OpenGL and log one line, once each.
  void fail(scene::Loss loss, const char* why) noexcept;
  /// Call after each glClear of depth: pauses count them.
  void depthCleared() noexcept;

  /// Runs `body`. If it throws, fail() decides, and a default value is returned.
  template <class F>
  auto protect(F&& body) noexcept -> decltype(body());
  /// protect(), repeated once if `body` throws: by then the real OpenGL has drawn the failed capture, and
  /// memory may be free again.
  template <class F>
  void insist(F&& body) noexcept;
  /// Runs `trace`, which adds a draw to the batch or returns why not. If it throws, fail() decides, and the
  /// reason is returned, so that the draw is rasterised, not lost.
  template <class F>
  Reason attempt(F&& trace);

 private:
  std::function<void()> drawHeld_;
  bool gone_ = false;
  bool told_ = false;  // of the first pause
  int pause_ = 0;      // clears of depth that still have to come; 0: none
  int nextPause_ = 1;  // in clears of depth
  int since_ = 0;      // clears of depth since the last pause
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
