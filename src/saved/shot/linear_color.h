// Linear light of what a program shows. Pure functions; any thread.
#pragma once
#include "scene/srgb.h"

#include <glm/glm.hpp>

namespace gluray::saved {

/// Premultiplied linear light of a premultiplied displayed colour: the colour without its alpha is decoded by
/// the curve of sRGB, which goes on beyond 1. Light without opacity, such as that of sums, is decoded as it
/// is.
inline glm::vec4 lightOf(const glm::vec4& displayed) {
  const float alpha = displayed.a > 0 && displayed.a < 1 ? displayed.a : 1;
  glm::vec4 linear(0, 0, 0, displayed.a);
  for (int c = 0; c < 3; ++c) linear[c] = alpha * scene::decodedSrgb(displayed[c] / alpha);
  return linear;
}

}  // namespace gluray::saved
