// The buffers of a window, read and cleared whatever the state. GL thread, context current.
#pragma once
#include "frame/window_content.h"
#include "gl/batch/presenter.h"
#include "intercept/present/features.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

namespace gluray::present {

/// Reads `buffer` of a window of `size` pixels. False where it cannot be read. State stays as it is.
bool readWindow(const gl::RealGl& real, const Features& features, glm::ivec2 size, GLenum buffer,
                frame::WindowContent& out);

/// Clears the window's whole back buffer, whatever the state, which stays as it is.
void clearWindow(const gl::RealGl& real, const Features& features, const gl::WindowClear& clear);

}  // namespace gluray::present
