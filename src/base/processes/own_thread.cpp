#include "base/processes/own_thread.h"

#include <cstddef>
#include <initializer_list>

namespace gluray {
namespace {

constexpr size_t kMinStack = size_t{2} << 20;  // bytes

/// The default size has room for the program's thread-local objects, which are also on the stack.
size_t stackSize() {
  size_t usual = 0;
  pthread_attr_t attributes;
  if (pthread_getattr_default_np(&attributes) != 0) return kMinStack;
  pthread_attr_getstacksize(&attributes, &usual);
  pthread_attr_destroy(&attributes);
  return usual < kMinStack ? usual + kMinStack : usual;
}

}  // namespace

SignalsBlocked::SignalsBlocked() {
  sigset_t blocked;
  sigfillset(&blocked);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP}) sigdelset(&blocked, fault);
  pthread_sigmask(SIG_SETMASK, &blocked, &saved_);
}

SignalsBlocked::~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &saved_, nullptr); }

bool startThread(pthread_t& thread, void* (*run)(void*), void* argument) noexcept {
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) != 0) return false;
  const SignalsBlocked signals;
  const bool started = pthread_attr_setstacksize(&attributes, stackSize()) == 0 &&
                       pthread_create(&thread, &attributes, run, argument) == 0;
  pthread_attr_destroy(&attributes);
  return started;
}

}  // namespace gluray
