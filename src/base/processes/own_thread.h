// Starts GLuRay's own threads inside the program. Any thread.
#pragma once
#include <pthread.h>

#include <csignal>

namespace gluray {

/// Blocks the host's signals for threads started during its lifetime: the host's handlers must not run on
/// GLuRay's threads.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t saved_;
};

/// Starts a joinable thread that runs run(argument), with the host's signals blocked. Its stack has the
/// default size, but at least 2 MB whatever the stack limit is (ulimit -s). Returns false if no thread can be
/// started.
bool startThread(pthread_t& thread, void* (*run)(void*), void* argument) noexcept;

}  // namespace gluray
