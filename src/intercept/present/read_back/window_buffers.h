// Reads and clears a window's buffers, independent of the GL state. GL thread, context current.
#pragma once
#include "frame/pixels/window_content.h"
#include "gl/batch/presenter.h"
#include "intercept/present/state/features.h"

#include <GL/gl.h>
#include <glm/glm.hpp>

#include <cstdint>
#include <span>

namespace gluray::present {

/// Reads `buffer` of a window of `size` pixels. False if it cannot be read. Restores all state.
bool readWindow(const gl::RealGl& real, const Features& features, glm::ivec2 size, GLenum buffer,
                frame::WindowContent& out);

/// Reads the colours of `buffer` of a window into `out`, RGBA8, bottom row first, which has room for `size`.
/// `read`: whether that was possible. Restores all state. Returns the program's error that was pending, if
/// any.
GLenum readColors(const gl::RealGl& real, const Features& features, glm::ivec2 size, GLenum buffer,
                  std::span<uint32_t> out, bool& read);

/// The same from the bound read framebuffer and its read buffer.
GLenum readBoundColors(const gl::RealGl& real, const Features& features, glm::ivec2 size,
                       std::span<uint32_t> out, bool& read);

/// Clears the window's whole back buffer. Restores all state.
void clearWindow(const gl::RealGl& real, const Features& features, const gl::WindowClear& clear);

}  // namespace gluray::present
