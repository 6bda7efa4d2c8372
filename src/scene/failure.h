// Failures, their exceptions, and the scope of their loss. Any thread.
#pragma once
#include <exception>
#include <stdexcept>
#include <string>

namespace gluray::scene {

/// Scope of the loss after a failure; the smallest that keeps every image correct.
enum class Loss {
  draws,    // some draws cannot be traced: the real OpenGL makes them; all other draws are traced
  frames,   // out of memory or threads: the real OpenGL draws for a while, then tracing is tried again
  tracing,  // GLuRay's own state cannot be trusted: the real OpenGL draws from here on
};

/// A failure with its loss.
struct Failure : std::runtime_error {
  Failure(const std::string& why, Loss of) : std::runtime_error(why), loss(of) {}
  Loss loss;
};

/// A draw that cannot be traced, such as a surface with a singular matrix.
struct Untraceable : Failure {
  explicit Untraceable(const std::string& why) : Failure(why, Loss::draws) {}
};

/// Loss of an exception: its own loss for a Failure; frames for std::bad_alloc, and for std::system_error
/// from a lack of memory or threads; otherwise tracing.
Loss lossOf(const std::exception& failure) noexcept;

}  // namespace gluray::scene
