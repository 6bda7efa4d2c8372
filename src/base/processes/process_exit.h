// Whether the process is ending. Any thread.
#pragma once

namespace gluray {

/// Makes isExiting() become true before exit() destroys any static object that was constructed before this
/// call: exit() runs handlers and destructors in reverse order of their registration. Call it again for
/// objects that were constructed since. Each call registers one handler.
void watchForExit() noexcept;

/// Whether exit() has begun, as far as watchForExit() covers it. Libraries may have destroyed their static
/// objects by then, and must not be used for anything new.
bool isExiting() noexcept;

}  // namespace gluray
