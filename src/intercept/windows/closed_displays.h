// Detects whether the program has closed its connection to an X server, and with it all its windows. Any
// thread.
#pragma once
#include <atomic>
#include <memory>

struct _XDisplay;  // Xlib's Display, without its header's macros

namespace gluray::intercept {

using Closed = std::shared_ptr<std::atomic<bool>>;

/// A flag that is set when the connection is closed. Null if that cannot be detected. Throws std::bad_alloc.
Closed watchDisplay(_XDisplay* display);

}  // namespace gluray::intercept
