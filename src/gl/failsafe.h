// Catches our own failures: after the first one the context steps aside and the real OpenGL draws everything.
// A part of each Context, GL thread.
#pragma once
#include "gl/draws/reasons.h"

#include <exception>
#include <functional>
#include <type_traits>
#include <utility>

namespace gluray::gl {

class Failsafe {
 public:
  /// `drawHeld` gives pending draws to the real OpenGL. It may throw.
  explicit Failsafe(std::function<void()> drawHeld) : drawHeld_(std::move(drawHeld)) {}

  bool aside() const { return aside_; }
  /// Rasterises every later draw and gives pending ones to the real OpenGL. Logs the first `why`.
  void stepAside(const char* why) noexcept;
  /// Runs `body`. If it throws, the context steps aside, and a default value is returned.
  template <class F>
  auto protect(F&& body) noexcept -> decltype(body());
  /// protect(), repeated once if `body` throws: by then the real OpenGL has drawn the failed capture, and
  /// memory may be free again.
  template <class F>
  void insist(F&& body) noexcept;
  /// Runs `trace`, which adds a draw to the batch or returns why not. If it throws, the context steps aside
  /// and Reason::failure is returned, so that the draw is rasterised, not lost.
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
