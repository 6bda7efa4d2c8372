// Keeps GLuRay's errors from the program, and disables GLuRay in forked children. Any thread.
#pragma once
#include "base/log.h"

#include <exception>
#include <string>

namespace gluray::intercept {

/// Call in the child of a fork, which has none of GLuRay's threads.
void noteFork() noexcept;
/// Whether this process is such a child: it passes all calls through.
bool isForkedChild() noexcept;

/// Runs `body`, and logs its exceptions once instead of passing them on. Does nothing in a forked child.
template <class F>
void guarded(const char* what, F&& body) noexcept {
  if (isForkedChild()) return;
  try {
    body();
  } catch (const std::exception& e) {
    log::once(log::Level::error, what, std::string(what) + ": " + e.what());
  } catch (...) { log::once(log::Level::error, what, what); }
}

}  // namespace gluray::intercept
