// Failures of ours end here: after the first one the context steps aside, and the real OpenGL draws
// everything. A part of each Context, GL thread.
#pragma once
#include "gl/draws/reasons.h"

#include <exception>
#include <functional>
#include <type_traits>
#include <utility>

namespace gluray::gl {

class Failsafe {
 public:
  /// `drawHeld` gives the real OpenGL what was held back. It may throw.
  explicit Failsafe(std::function<void()> drawHeld) : drawHeld_(std::move(drawHeld)) {}

  bool aside() const { return aside_; }
  /// From now on every draw is rasterised; what was held back is given to the real OpenGL.
  void stepAside(const char* why) noexcept;
  /// Runs `body`; where it throws, the context steps aside.
  template <class F>
  auto protect(F&& body) noexcept -> decltype(body());
  /// protect(), and once more where a failure came before `body` was done: a capture that failed has become a
  /// draw of the real OpenGL by then, and memory may be there again.
  template <class F>
  void insist(F&& body) noexcept;
  /// Runs `trace`, which says whether it added a draw to the batch. A failure of ours makes the draw
  /// rasterised, not lost.
  template <class F>
  Reason attempt(F&& trace);

 private:
  std::function<void()> drawHeld_;
  bool aside_ = false;
};

template <class F>
auto Failsafe::protect(F&& body) noexcept -> decltype(body()) {
  try {
    return body();
  } catch (const std::exception& e) { stepAside(e.what()); } catch (...) {
    stepAside("unknown error");
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
  } catch (const std::exception& e) { stepAside(e.what()); }
  return Reason::failure;
}

}  // namespace gluray::gl
