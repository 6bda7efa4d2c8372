// The pixels of a window as values, and how a traced picture joins them without OpenGL: for frames that are
// shown late. Any thread.
#pragma once
#include "base/image.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::frame {

/// All pixels of a window, bottom row first.
struct WindowContent {
  int width = 0, height = 0;
  std::vector<uint32_t> colors;  // RGBA8, red in the lowest byte
  std::vector<float> depths;     // window depth
};

/// Which hits pass OpenGL's depth test against the depth that is there.
enum class DepthTest : uint8_t { less, lessOrEqual };

/// A window of one colour, and of that depth.
WindowContent plainWindow(glm::ivec2 size, uint32_t color, float depth);

/// Writes what is traced over `content` where the depth test lets it, as the write-back does. False for
/// pictures of samples or of other colours than RGBA8.
bool merge(const Image& image, DepthTest test, WindowContent& content) noexcept;

}  // namespace gluray::frame
