// How the samples of a multisampled picture become pixels.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::scene {

struct Resolve {
  glm::ivec2 size{0};       // pixels of what the samples are of, from (0, 0) on
  uint32_t background = 0;  // RGBA8 of samples that nothing hit; their depth is 1
  float farthest = 1;       // window depth beyond which a hit does not pass the depth test
  float gamma = 1;          // red, green and blue are averaged to this power; alpha is as it is

  bool operator==(const Resolve&) const = default;
};

}  // namespace gluray::scene
