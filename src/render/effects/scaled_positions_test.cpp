// Toolkits scale the positions of a mesh to a unit cube, each axis by itself, and leave its normals as they
// are.
#include "render/testing/lit_wall.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace gluray::render {
namespace {

/// A bulging strip with smooth normals before a wall, in the shader of a program with a matrix for normals.
/// `scale`: what the program has multiplied the strip's positions by.
scene::Snapshot strip(const glm::vec3& scale, bool hasLightingSpace) {
  gluray::test::MeshData data;
  constexpr int kSteps = 24;
  for (int i = 0; i < kSteps; ++i) {
    const auto at = [&](int step, float y) {
      const float angle = 3.0f * static_cast<float>(step) / kSteps - 1.5f;
      const glm::vec3 normal(std::sin(angle), 0, std::cos(angle));
      data.positions.push_back((glm::vec3(1.2f, 1, 0.4f) * normal + glm::vec3(0, y, 0.1f)) * scale);
      data.normals.push_back(glm::normalize(normal / glm::vec3(1.2f, 1, 0.4f)));
    };
    for (const auto& [step, y] :
         {std::pair(i, -1.0f), {i + 1, -1.0f}, {i + 1, 1.0f}, {i, -1.0f}, {i + 1, 1.0f}, {i, 1.0f}})
      at(step, y);
  }
  scene::Snapshot s = gluray::test::litView({gluray::test::wall(), gluray::test::makeMesh(data)},
                                            gluray::test::Shader::phong, {0.6f, 0.3f, 1, 0});
  const glm::dmat4 objectFromScaled = glm::scale(glm::dmat4(1), 1.0 / glm::dvec3(scale));
  scene::Instance& instance = s.instances[1];
  instance.eyeFromObject = s.eyeFromWorld * objectFromScaled;
  instance.worldFromObject = glm::mat4(objectFromScaled);
  instance.normalMatrix = glm::mat3(1);
  s.shadings.push_back(s.shadings[0]);
  instance.shading = 1;
  s.shadings[1].fragment.normals = scene::FragmentShading::Normals::vertices;
  instance.lightingFromObject = hasLightingSpace ? glm::mat4(instance.eyeFromObject) : glm::mat4(1);
  s.settings.ao.enabled = true, s.settings.ao.samples = 8, s.settings.ao.distance = 2;
  return s;
}

/// Largest difference of a channel, and how many pixels differ by more than one step.
std::pair<int, int> difference(const Image& a, const Image& b) {
  int most = 0, pixels = 0;
  for (size_t i = 0; i < a.color.size(); ++i) {
    int here = 0;
    for (int c = 0; c < 24; c += 8)
      here = std::max(here, std::abs(int(a.color[i] >> c & 255) - int(b.color[i] >> c & 255)));
    most = std::max(most, here), pixels += here > 1;
  }
  return {most, pixels};
}

TEST(ScaledPositions, LightIsAsWithoutTheScales) {
  for (const bool hasLightingSpace : {true, false}) {
    const Image plain = gluray::test::trace(strip(glm::vec3(1), hasLightingSpace)).image;
    const Image scaled = gluray::test::trace(strip({0.8f, 0.5f, 3}, hasLightingSpace)).image;
    const auto [most, pixels] = difference(plain, scaled);
    // Rounding moves few rays past an edge.
    EXPECT_LE(pixels, 40) << "of " << plain.color.size() << ", by " << most;
    scene::Snapshot unlit = strip(glm::vec3(1), hasLightingSpace);
    unlit.settings.ao.enabled = false;
    EXPECT_GT(difference(plain, gluray::test::trace(unlit).image).second, 400) << "occlusion is seen";
  }
}

}  // namespace
}  // namespace gluray::render
