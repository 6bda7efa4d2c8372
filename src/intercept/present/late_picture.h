// What a window's back buffer holds of a frame that is shown late, and how a traced picture joins it without
// OpenGL. GL thread but for merge(), which any thread may call.
#pragma once
#include "base/image.h"
#include "gl/presenter.h"
#include "intercept/present/state_guard.h"

#include <cstdint>
#include <vector>

namespace gluray::present {

/// All pixels of a window, bottom row first.
struct WindowContent {
  int width = 0, height = 0;
  std::vector<uint32_t> colors;  // RGBA8, red in the lowest byte
  std::vector<float> depths;     // window depth
};

/// A window of one colour, and of that depth.
WindowContent plainWindow(glm::ivec2 size, uint32_t color, float depth);

/// Reads `buffer` of a window of `size` pixels. False where it cannot be read. State stays as it is.
bool readWindow(const gl::RealGl& real, const Features& features, glm::ivec2 size, GLenum buffer,
                WindowContent& out);

/// Writes what is traced over `content` where the depth test `depthFunc` (LESS or LEQUAL) lets it, as the
/// write-back does. False for pictures of samples or of other colours than RGBA8.
bool merge(const Image& image, GLenum depthFunc, WindowContent& content) noexcept;

/// Clears the window's whole back buffer, whatever the state, which stays as it is.
void clearWindow(const gl::RealGl& real, const Features& features, const gl::WindowClear& clear);

}  // namespace gluray::present
