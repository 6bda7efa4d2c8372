// What becomes of OpenGL calls on a thread without a context of ours: the program may have made one current
// by a way that no door sees. Set by the doors, read by every stub.
#pragma once
#include "gl/real.h"

#include <atomic>

namespace gluray::intercept {

inline std::atomic<const gl::RealGl*> g_orphanGl = nullptr;

/// The real OpenGL for calls without a context, or null: then such calls do nothing, as OpenGL leaves them
/// undefined.
inline const gl::RealGl* orphanGl() { return g_orphanGl.load(std::memory_order_acquire); }

}  // namespace gluray::intercept
