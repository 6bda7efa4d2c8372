// Shared by tests of the common scenes: each scene as a test parameter, and its image by the real OpenGL.
#pragma once
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

namespace gluray::test {

constexpr int kSceneWidth = 320, kSceneHeight = 240;

inline DrawnImage drawReal(const scenes::Scene& scene) {
  const auto context = OsmesaContext::create({kSceneWidth, kSceneHeight});
  scene.draw(context->real(), kSceneWidth, kSceneHeight);
  return readImage(context->real(), kSceneWidth, kSceneHeight);
}

/// drawReal(), drawn once a process. One that takes 150 scenes holds 100 MB of them.
inline const DrawnImage& realImage(const scenes::Scene& scene) {
  static std::map<const scenes::Scene*, DrawnImage> drawn;
  const auto [place, isNew] = drawn.try_emplace(&scene);
  if (isNew) place->second = drawReal(scene);
  return place->second;
}

inline std::vector<const scenes::Scene*> pointers(std::span<const scenes::Scene> list) {
  std::vector<const scenes::Scene*> all;
  for (const scenes::Scene& scene : list) all.push_back(&scene);
  return all;
}

inline std::string sceneNameOf(const testing::TestParamInfo<const scenes::Scene*>& info) {
  std::string name = info.param->name;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

}  // namespace gluray::test
