// Threads for what is done to finished pictures.
#pragma once
#include <functional>

namespace gluray::accel {

/// Calls work(0) to work(count - 1), on `threads` threads (0: as many as the process may use), the caller's
/// included. They are not those of a frame that is being rendered, so that nobody waits for it. Throws what
/// `work` does, and std::bad_alloc. Any thread.
void forEachPart(int threads, int count, const std::function<void(int)>& work);

}  // namespace gluray::accel
