// Parameters for resolving a multisampled image into pixels.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::scene {

struct Resolve {
  glm::ivec2 size{0};       // pixels of the multisampled framebuffer, from (0, 0)
  uint32_t background = 0;  // RGBA8 of samples without a hit; their depth is 1
  float farthest = 1;       // largest window depth that passes the depth test
  float gamma = 1;          // exponent applied to red, green and blue for averaging; alpha is linear

  bool operator==(const Resolve&) const = default;
};

}  // namespace gluray::scene
