// Environments and textures of physically based materials against analytic values.
#include "render/shading/pbr_environment.h"

#include "render/local/texture_lookup.h"
#include "render/shading/pbr_textures.h"

#include <gtest/gtest.h>

namespace gluray {
namespace {

/// A cube map whose levels are `side`, side / 2 ...; value(face, x, y, level) of each texel.
template <class Value>
scene::Texture cubeOf(int side, int levels, Value&& value) {
  auto image = std::make_shared<scene::TextureImage>();
  image->mipmaps.resize(static_cast<size_t>(levels - 1));
  for (int level = 0; level < levels; ++level) {
    scene::TexelGrid& grid = level ? image->mipmaps[static_cast<size_t>(level - 1)] : *image;
    grid.width = grid.height = side >> level, grid.depth = 6;
    for (int face = 0; face < 6; ++face)
      for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x) grid.floats.emplace_back(value(face, x, y, level));
  }
  scene::Texture t;
  t.image = image;
  t.target = scene::TextureTarget::cubeMap;
  t.seamless = true;
  t.mipFilter = levels > 1 ? scene::MipFilter::linear : scene::MipFilter::none;
  return t;
}

float redIn(const scene::Texture& t, const glm::vec3& direction) {
  const int face = render::cubeFace(direction);
  const glm::vec2 st(render::coordinatesInFace(face, direction));
  return render::sampleLevel(t, *t.image, scene::Filter::linear, {st, static_cast<float>(face)}).r;
}

TEST(SeamlessCube, IsTheSameOnBothSidesOfEveryEdge) {
  const auto t = cubeOf(4, 1, [](int face, int x, int y, int) { return glm::vec4(float(7 * face + x * y)); });
  for (int axis = 0; axis < 3; ++axis)
    for (int other = 0; other < 3; ++other)
      for (const float a : {-1.0f, 1.0f})
        for (const float b : {-1.0f, 1.0f})
          for (float along = -0.7f; along < 0.8f && axis != other; along += 0.23f) {
            glm::vec3 edge(along);
            edge[axis] = a, edge[other] = b;
            glm::vec3 near = edge, far = edge;
            near[axis] *= 1.0001f, far[other] *= 1.0001f;
            EXPECT_NE(render::cubeFace(near), render::cubeFace(far));
            EXPECT_NEAR(redIn(t, near), redIn(t, far), 0.02f) << axis << other << a << b << along;
          }
}

TEST(SeamlessCube, OnAnEdgeIsTheMeanOfBothFaces) {
  const auto t = cubeOf(4, 1, [](int face, int, int, int) { return glm::vec4(float(face)); });
  EXPECT_NEAR(redIn(t, {1, 0.1f, 1}), 2, 1e-5f);      // +x: 0, +z: 4
  EXPECT_NEAR(redIn(t, {-1, 1, 0.3f}), 1.5f, 1e-5f);  // -x: 1, +y: 2
  EXPECT_NEAR(redIn(t, {1, 0.1f, 0.2f}), 0, 0) << "inside of a face";
}

TEST(SeamlessCube, AtACornerIsTheMeanOfThreeFaces) {
  const auto t = cubeOf(4, 1, [](int face, int, int, int) { return glm::vec4(float(face)); });
  EXPECT_NEAR(redIn(t, {1, 1, 1}), (0 + 2 + 4) / 3.0f, 1e-5f);
  EXPECT_NEAR(redIn(t, {-1, -1, -1}), (1 + 3 + 5) / 3.0f, 1e-5f);
}

TEST(SeamlessCube, OfOneTexelBlendsFaces) {
  const auto t = cubeOf(1, 1, [](int face, int, int, int) { return glm::vec4(float(face)); });
  EXPECT_NEAR(redIn(t, {1, 0, 0}), 0, 1e-6f);
  EXPECT_NEAR(redIn(t, {1, 0, 1}), 2, 1e-5f);
}

TEST(PbrEnvironment, RougherSurfacesSeeSmallerLevels) {
  scene::PbrEnvironment e;
  e.prefiltered = {cubeOf(16, 5, [](int, int, int, int level) { return glm::vec4(float(level)); })};
  e.maxLevel = 4;
  for (const scene::LodRule rule : {scene::LodRule::specified, scene::LodRule::llvmpipe}) {
    e.prefiltered[0].lodRule = rule;
    for (const float roughness : {0.0f, 0.1f, 0.5f, 0.8f, 1.0f})
      EXPECT_NEAR(render::prefilteredFrom(e, glm::vec3(0, 0, 1), roughness).r, 4 * roughness, 1e-5f);
  }
  e.maxLevel = 2;
  EXPECT_NEAR(render::prefilteredFrom(e, glm::vec3(0, 0, 1), 0.25f).r, 0.5f, 1e-5f);
}

TEST(PbrEnvironment, IsTurnedByItsMatrix) {
  scene::PbrEnvironment e;
  e.irradiance =
      e.prefiltered = {cubeOf(4, 1, [](int face, int, int, int) { return glm::vec4(float(face)); })};
  e.worldFromEye = glm::mat3(0, 1, 0, 0, 0, 1, 1, 0, 0);  // x to y, y to z, z to x
  EXPECT_EQ(render::irradianceOf(e, glm::vec3(1, 0, 0)).r, 2);
  EXPECT_EQ(render::irradianceOf(e, glm::vec3(0, -1, 0)).r, 5);
  EXPECT_EQ(render::prefilteredFrom(e, glm::vec3(0, 0, 1), 0.5f).r, 0);
}

/// Each coefficient alone, at a direction where its function has a known value.
TEST(PbrEnvironment, HarmonicsAreTheirFunctions) {
  const glm::vec3 n = glm::normalize(glm::vec3(0.6f, 0.5f, 0.4f));
  const float values[9] = {
      1, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3 * n.z * n.z - 1, n.x * n.z, n.x * n.x - n.y * n.y};
  for (size_t i = 0; i < 9; ++i) {
    scene::PbrEnvironment e;
    e.byHarmonics = true;
    const float sign = values[i] < 0 ? -1.0f : 1.0f;
    e.harmonics[0][i] = sign, e.harmonics[1][i] = -sign, e.harmonics[2][i] = 2 * sign;
    const glm::vec3 light = render::irradianceOf(e, n);
    EXPECT_NEAR(light.r, std::abs(values[i]), 1e-6f) << i;
    EXPECT_EQ(light.g, 0) << "never negative";
    EXPECT_NEAR(light.b, 2 * std::abs(values[i]), 2e-6f) << i;
  }
}

TEST(NormalMap, BendsTowardsTangentAndBitangent) {
  const glm::vec3 n(0, 0, 1), leaning(2, 0, 0.7f);  // made perpendicular to n, and of length 1
  const auto bent = [&](const glm::vec3& texel) { return render::mappedNormal(n, leaning, texel); };
  EXPECT_NEAR(glm::distance(bent({0, 0, 1}), n), 0, 1e-6f);
  EXPECT_NEAR(glm::distance(bent({1, 0, 0}), glm::vec3(1, 0, 0)), 0, 1e-6f);
  EXPECT_NEAR(glm::distance(bent({0, 1, 0}), glm::vec3(0, 1, 0)), 0, 1e-6f);  // cross(n, tangent)
  const float half = std::sqrt(0.5f);
  EXPECT_NEAR(glm::distance(bent({half, 0, half}), glm::vec3(half, 0, half)), 0, 1e-6f);
}

}  // namespace
}  // namespace gluray
