// What the panel waits for before it ends: batches that set settings back. GUI thread.
#pragma once
#include <chrono>

namespace gluray::panel {

class Controls;

/// Runs an event loop until all batches are answered, at most so long. No other event loop may run: the
/// application's has ended, or has not begun.
void finishChanges(const Controls& controls, std::chrono::milliseconds most = std::chrono::seconds(3));

}  // namespace gluray::panel
