// Starts GLuRay's own threads inside the program. Any thread.
#pragma once
#include <pthread.h>

#include <csignal>

namespace gluray {

/// Blocks the host's signals for threads started during its lifetime: the host's handlers must not run on our
/// threads.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t saved_;
};

/// Starts a joinable thread that runs run(argument), with the host's signals blocked. Its stack has the usual
/// size, but at least 2 MB whatever the limit of stacks is (ulimit -s). False: none can be started.
bool startThread(pthread_t& thread, void* (*run)(void*), void* argument) noexcept;

}  // namespace gluray
