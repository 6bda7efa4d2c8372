// The real OpenGL for calls on a thread without a context of GLuRay: the program may have made a context
// current that no door saw. Set by the hooks, read by every stub. Any thread.
#pragma once
#include "gl/real/real.h"

#include <atomic>

namespace gluray::intercept {

inline std::atomic<const gl::RealGl*> g_orphanGl = nullptr;  // of the first context of the process
inline thread_local const gl::RealGl* t_orphanGl = nullptr;  // of the current context, even an unknown one

/// The real OpenGL for calls without a context of GLuRay. Null: such calls do nothing, because OpenGL leaves
/// them undefined.
inline const gl::RealGl* orphanGl() {
  return t_orphanGl ? t_orphanGl : g_orphanGl.load(std::memory_order_acquire);
}

}  // namespace gluray::intercept
