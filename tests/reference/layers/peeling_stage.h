// Expectations for peeled scenes, for the tests of depth peeling.
#pragma once
#include "tests/reference/layers/peeler.h"

#include <functional>
#include <string>
#include <vector>

namespace gluray::test {

/// The real OpenGL rounds layers to eight bits in every peel, GLuRay once.
inline constexpr scenes::Tolerance kPeelTolerance = {
    3, 0.004, 1e-5f, "silhouettes of all layers; every peel rounds to eight bits"};

inline void expectPeeled(const std::string& name, const std::vector<Layer>& all, int draws,
                         const std::function<Peeler::Hooks(Gl, Peeler&)>& hooksOf = {}) {
  const auto draw = [&](Gl gl) {
    Peeler peeler(gl);
    const Peeler::Hooks hooks = hooksOf ? hooksOf(gl, peeler) : Peeler::Hooks{};
    peeler.frame(all, hooks);
    peeler.frame(all, hooks);
  };
  expectBoth(name, draw, draws, {}, kPeelTolerance);
}

/// Parallel flat layers, `step` apart, the nearest first.
inline std::vector<Layer> row(int count, float opacity, double step) {
  std::vector<Layer> all;
  for (int i = 0; i < count; ++i) {
    const float x = static_cast<float>(i) / static_cast<float>(count);
    all.push_back(seen(sheet(12), {x, 0.5f, 1 - x}, opacity, placed({0, 0, 0.6 - step * i}, 0.7)));
  }
  return all;
}

}  // namespace gluray::test
