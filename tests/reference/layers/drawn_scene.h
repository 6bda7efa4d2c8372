// What tests of the common scenes share: each scene as a test parameter, and its picture by the real OpenGL.
#pragma once
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

namespace gluray::test {

constexpr int kWidth = 320, kHeight = 240;

inline Picture drawReal(const scenes::Scene& scene) {
  const auto context = OsmesaContext::create({kWidth, kHeight});
  scene.draw(context->real(), kWidth, kHeight);
  return readPicture(context->real(), kWidth, kHeight);
}

inline std::vector<const scenes::Scene*> pointers(std::span<const scenes::Scene> list) {
  std::vector<const scenes::Scene*> all;
  for (const scenes::Scene& scene : list) all.push_back(&scene);
  return all;
}

inline std::string nameOf(const testing::TestParamInfo<const scenes::Scene*>& info) {
  std::string name = info.param->name;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

}  // namespace gluray::test
