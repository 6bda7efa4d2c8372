// The pixels of a window in memory, and the depth-tested merge of a traced image into them without OpenGL:
// for frames that are shown late. Any thread.
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

/// OpenGL's depth test of hits against the existing depth.
enum class DepthTest : uint8_t { less, lessOrEqual };

/// A window cleared to one colour and depth.
WindowContent plainWindow(glm::ivec2 size, uint32_t color, float depth);

/// Writes the hits that pass the depth test into `content`, as the write-back does. False for multisampled
/// images and for colours other than RGBA8.
bool merge(const Image& image, DepthTest test, WindowContent& content) noexcept;

}  // namespace gluray::frame
