// Translucent sheets over the whole window, for tests of layers.
#pragma once
#include "render/testing/test_trace.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::test {

struct Sheet {
  float z;  // window depth is 0.5 - z/2
  glm::vec4 color;
};

/// Squares over the whole window, one instance each.
inline scene::Snapshot sheets(const std::vector<Sheet>& all, float opaqueDepth = -1) {
  std::vector<scene::MeshPtr> meshes;
  for (const Sheet& sheet : all) meshes.push_back(makeMesh(squareData(sheet.z)));
  auto s = makeSnapshot(meshes);
  for (size_t i = 0; i < all.size(); ++i) {
    s.instances[i].color = all[i].color;
    s.instances[i].order = static_cast<uint32_t>(i);
  }
  auto layers = std::make_shared<scene::Layers>();
  layers->opaqueDepth.assign(16 * 16, opaqueDepth);
  s.layers = layers;
  return s;
}

/// Blends the layer's colour over `under`, as glBlendFunc would in order.
inline glm::vec4 under(const glm::vec4& front, const glm::vec4& color) {
  const float weight = (1 - front.a) * color.a;
  return front + weight * glm::vec4(glm::vec3(color), 1);
}

inline void expectColor(const scene::Snapshot& s, const glm::vec4& expected) {
  const auto traced = trace(s);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      ASSERT_LE(difference(traced.color(x, y), glm::round(expected * 255.0f)), 1) << x << ' ' << y;
}

constexpr glm::vec4 kRed(1, 0, 0, 0.5f), kGreen(0, 1, 0, 0.25f), kBlue(0, 0, 1, 0.75f);

}  // namespace gluray::test
