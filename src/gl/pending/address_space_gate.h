// Tests whether the process's limits leave enough address space for the real OpenGL while an image is
// traced. GL thread.
#pragma once

namespace gluray::gl {

/// Asked before each image is traced, because programs take memory and set limits (adr/0088). Where there
/// were no limits, only each 32nd call looks for them.
bool addressSpaceIsShort() noexcept;

/// Why, for the log.
inline constexpr const char* kAddressSpaceIsShort =
    "limits of the process (ulimit -v, -d) leave too little for OpenGL";

}  // namespace gluray::gl
