// Chooses the new size of a reused texture for an image of another size. GL thread.
#pragma once
#include <glm/glm.hpp>

#include <algorithm>
#include <cstdint>

namespace gluray::present {

/// The new size in texels of a texture that has `held` and needs `wanted`; `held` if that suffices. Covers
/// both, so that images of similar shapes share the texture, unless that takes more than twice the texels
/// of the larger one: a texture for both 16384x16 and 16x16384 pixels would have 512 times as many.
inline glm::ivec2 grownSize(glm::ivec2 held, glm::ivec2 wanted) {
  if (wanted.x <= held.x && wanted.y <= held.y) return held;
  const auto texels = [](glm::ivec2 size) { return int64_t{size.x} * size.y; };
  const glm::ivec2 both = glm::max(held, wanted);
  return texels(both) <= 2 * std::max(texels(held), texels(wanted)) ? both : wanted;
}

}  // namespace gluray::present
