// The buffer objects that are bound to targets. Private to gl/buffers. GL thread.
#pragma once
#include "gl/buffers/buffer.h"

#include <GL/gl.h>

#include <memory>

namespace gluray::gl {

class Context;

/// The query that tells what is bound to a target; 0 for targets that we do not know.
GLenum bindingOf(GLenum target);

/// The buffer bound to `target`, null where there is none (the real OpenGL then says what is wrong), or where
/// it may be one that another context has deleted, which the real OpenGL alone knows then. Its name may mean
/// another one now, or it is that one after all: of that our copy is given up.
std::shared_ptr<Buffer> bound(Context& c, GLenum target);

}  // namespace gluray::gl
