// Whether limits of the process leave enough address space for the real OpenGL while a picture is traced. GL
// thread.
#pragma once

namespace gluray::gl {

/// Asked before each picture is traced. Costs two system calls where there are no limits.
bool addressSpaceIsShort() noexcept;

}  // namespace gluray::gl
