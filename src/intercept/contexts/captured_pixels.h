// The colours of a frame that is about to be saved.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::intercept {

struct CapturedPixels {
  glm::ivec2 size{0};            // pixels
  std::vector<uint32_t> colors;  // RGBA8, bottom row first
};

}  // namespace gluray::intercept
