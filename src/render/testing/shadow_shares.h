// Shadows on a wall as shares of its light, for tests.
#pragma once
#include "render/testing/lit_wall.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::test {

inline const glm::vec4 kFromTheRight{1, 0, 1, 0};

inline scene::Snapshot screened(Shader shader, const glm::vec4& light = kFromTheRight) {
  return litView({wall(), screen()}, shader, light);
}

/// The image's colours as shares of those without shadows, 0 .. 1.
inline std::vector<float> sharesOf(scene::Snapshot s, int channel = 1, int row = kLitSize / 2) {
  const Traced shadowed = trace(s);
  s.settings.shadows.enabled = false;
  const Traced plain = trace(s);
  std::vector<float> shares;
  for (int x = 0; x < kLitSize; ++x) {
    EXPECT_GT(plain.color(x, row)[channel], 0);
    shares.push_back(shadowed.color(x, row)[channel] / plain.color(x, row)[channel]);
  }
  return shares;
}

}  // namespace gluray::test
