// The buffer objects bound to targets. Private to gl/commands. GL thread.
#pragma once
#include "gl/buffers/buffer.h"

#include <GL/gl.h>

#include <memory>

namespace gluray::gl {

class Context;

/// The glGet name of a target's binding; 0 for unknown targets.
GLenum bindingOf(GLenum target);

/// The buffer bound to `target`. Null if there is none (the real OpenGL raises the error), or if it may be
/// one that another context has deleted, which only the real OpenGL knows. In that case the buffer that has
/// the name now may still be the bound one, so its contents are sent and our copy is dropped.
std::shared_ptr<Buffer> bound(Context& c, GLenum target);

}  // namespace gluray::gl
