// What failures cost, and the exceptions that say so. Any thread.
#pragma once
#include <exception>
#include <stdexcept>
#include <string>

namespace gluray::scene {

/// What is given up after a failure; the least that keeps every picture right.
enum class Loss {
  draws,    // what is drawn cannot be traced: the real OpenGL draws it, and everything else is traced on
  frames,   // memory or threads ran out: the real OpenGL draws for a while, then tracing is tried again
  tracing,  // GLuRay's own state cannot be trusted: the real OpenGL draws from here on
};

/// A failure that knows what it costs.
struct Failure : std::runtime_error {
  Failure(const std::string& why, Loss of) : std::runtime_error(why), loss(of) {}
  Loss loss;
};

/// What is drawn cannot be traced, such as a surface placed by a matrix that has no inverse.
struct Untraceable : Failure {
  explicit Untraceable(const std::string& why) : Failure(why, Loss::draws) {}
};

/// What an exception costs: its own loss if it is a Failure; frames if it is a std::bad_alloc or a
/// std::system_error of a lack of memory or threads; otherwise tracing.
Loss lossOf(const std::exception& failure) noexcept;

}  // namespace gluray::scene
