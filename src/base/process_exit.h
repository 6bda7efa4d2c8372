// Whether the process is ending. Any thread.
#pragma once

namespace gluray {

/// From now on isExiting() becomes true before exit() destroys any static object that was made before this
/// call: exit() runs handlers and destructors in reverse order of their registration. Call it again for
/// objects that were made since; each call registers one handler.
void watchForExit() noexcept;

/// Whether exit() has begun, as far as watchForExit() reaches. Libraries may have destroyed their static
/// objects by then, and must not be asked to do anything new.
bool isExiting() noexcept;

}  // namespace gluray
