// Which surfaces cast shadows, and on which they fall.
#include "render/testing/shadow_shares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace gluray::render {
namespace {

using test::kFromTheRight;
using test::kLitSize;
using test::screened;
using test::Shader;
using test::sharesOf;
using test::Traced;

TEST(Shadows, LampsDoNotHideTheirLights) {
  // An unlit box around the light at (4, 0, 4).
  const auto box = test::parallelogram({4, 0, 3.9f}, {0.2f, 0, 0}, {0, 0.2f, 0});
  for (const bool lit : {false, true}) {
    scene::Snapshot s = test::litView({test::wall(10), box}, Shader::fixedFunction, {4, 0, -1, 1});
    auto mesh = std::make_shared<scene::Mesh>(*s.instances[1].mesh);
    mesh->lower = {3.8f, -0.2f, 3.8f}, mesh->upper = {4.2f, 0.2f, 4.2f};
    s.instances[1].mesh = mesh;
    s.shadings.push_back(s.shadings[0]);
    s.shadings[1].lighting = lit;
    s.instances[1].shading = 1;
    EXPECT_EQ(sharesOf(s)[30] < 1, lit);
  }
}

TEST(Shadows, OfTranslucentPanesAreAsDarkAsTheirAlphaAndHaveTheirColour) {
  for (const float alpha : {0.0f, 0.25f, 0.5f, 1.0f}) {
    scene::Snapshot s = screened(Shader::fixedFunction);
    auto layers = std::make_shared<scene::Layers>();
    layers->opaqueDepth.assign(kLitSize * kLitSize, -1.0f);
    s.layers = layers;
    s.instances[1].materials[0].front.diffuse = {1, 0, 0, alpha};
    s.instances[1].materials[0].back = s.instances[1].materials[0].front;
    // The red pane passes (1 - a) of red, and (1 - a)^2 of the rest.
    EXPECT_NEAR(sharesOf(s, 0)[60], 1 - alpha, 0.006f) << alpha;
    EXPECT_NEAR(sharesOf(s, 1)[60], (1 - alpha) * (1 - alpha), 0.006f) << alpha;
    EXPECT_EQ(sharesOf(s, 1)[5], 1);
    s.instances[1].materials[0].front.diffuse = {0.3f, 0.3f, 0.3f, alpha};
    EXPECT_NEAR(sharesOf(s, 1)[60], 1 - alpha, 0.006f) << "grey panes do not tint";
  }
}

TEST(Shadows, OfPanesWithVertexColorsHaveThemRaisedToTheirExponent) {
  for (const float exponent : {1.0f, 2.0f}) {
    scene::Snapshot s = screened(Shader::phong);
    auto layers = std::make_shared<scene::Layers>();
    layers->opaqueDepth.assign(kLitSize * kLitSize, -1.0f);
    s.layers = layers;
    s.shadings.push_back(s.shadings[0]);
    s.shadings[1].fragment.color = scene::FragmentShading::Color::vertices;
    s.shadings[1].fragment.colorExponent = exponent;
    s.instances[1].shading = 1;
    s.instances[1].color = {1, 0.5f, 0.5f, 0.5f};
    EXPECT_NEAR(sharesOf(s, 0)[60], 0.5f, 0.006f);
    EXPECT_NEAR(sharesOf(s, 1)[60], 0.5f * (0.5f + 0.5f * std::pow(0.5f, exponent)), 0.006f) << exponent;
  }
}

TEST(Shadows, WhatClipPlanesCutAwayCastsNone) {
  scene::Snapshot s = screened(Shader::fixedFunction);
  s.instances[1].clipPlanes = {{0, 0, -1, -4.5}};  // eye space: keeps z <= -4.5, and the screen is at -4
  for (const float share : sharesOf(s)) EXPECT_EQ(share, 1);
}

/// A box about the origin whose normals point inwards; the viewer sees its side z = 1.
scene::MeshPtr insideOutBox() {
  test::MeshData data;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const float sign = side % 2 ? 1.0f : -1.0f;
    glm::vec3 n(0), u(0), v(0);
    n[axis] = sign, u[(axis + 1) % 3] = 1, v[(axis + 2) % 3] = sign;
    const auto first = static_cast<uint32_t>(data.positions.size());
    for (const glm::vec2 k : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
      data.positions.push_back(n + k.x * u + k.y * v);
      data.normals.push_back(-n);
    }
    for (const uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) data.indices.push_back(first + k);
  }
  return test::makeMesh(data);
}

// Programs whose normals point inwards have their lights on the other side, too.
TEST(Shadows, SurfacesThatAreLitFromTheirFarSideDoNotShadeThemselves) {
  const glm::vec4 behind{0.1f, 0, -1, 0};
  for (const bool twoSided : {false, true}) {
    scene::Snapshot s = test::litView({insideOutBox()}, Shader::fixedFunction, behind);
    s.shadings[0].twoSided = twoSided;
    const Traced shadowed = test::trace(s);
    s.settings.shadows.enabled = false;
    const Traced plain = test::trace(s);
    const int middle = kLitSize / 2;
    EXPECT_GT(plain.color(middle, middle).g, 200);
    EXPECT_EQ(shadowed.color(middle, middle), plain.color(middle, middle)) << twoSided;
  }
  // What lies between it and the light does.
  scene::Snapshot s = test::litView({insideOutBox(), test::parallelogram({0, 0, -5}, {50, 0, 0}, {0, 50, 0})},
                                    Shader::fixedFunction, behind);
  EXPECT_LT(test::trace(s).color(kLitSize / 2, kLitSize / 2).g, 10);
}

TEST(Shadows, HolesOfTheAlphaTestCastNone) {
  scene::Snapshot s = screened(Shader::fixedFunction);
  s.shadings.push_back(s.shadings[0]);
  s.shadings[1].alphaTest = {scene::AlphaTest::greater, false, 0.5f};
  s.instances[1].shading = 1;
  const auto shareWithAlpha = [&](float alpha) {
    s.instances[1].materials[0].front.diffuse = s.instances[1].materials[0].back.diffuse = {1, 1, 1, alpha};
    return sharesOf(s)[60];
  };
  EXPECT_EQ(shareWithAlpha(0.3f), 1);
  EXPECT_EQ(shareWithAlpha(0.7f), 0);
  auto image = std::make_shared<scene::TextureImage>();
  image->width = 2, image->height = 1, image->opaque = false;
  image->texels = {0x00FFFFFFu, 0xFFFFFFFFu};  // a hole at the left
  scene::Texture texture;
  texture.image = image, texture.magFilter = scene::Filter::nearest;
  s.shadings[1].textures = {texture};
  s.instances[1].texcoord = {0.25f, 0.5f, 0, 1};
  EXPECT_EQ(shareWithAlpha(1), 1);
  s.instances[1].texcoord = {0.75f, 0.5f, 0, 1};
  EXPECT_EQ(shareWithAlpha(1), 0);
  EXPECT_EQ(shareWithAlpha(0.3f), 1) << "the alpha of the material is a factor";
}

TEST(Shadows, CulledSidesCastThem) {
  for (const scene::CullFace cull : {scene::CullFace::front, scene::CullFace::back}) {
    scene::Snapshot s = screened(Shader::fixedFunction);
    s.instances[1].cull = cull;
    EXPECT_EQ(sharesOf(s)[60], 0);
  }
}

TEST(Shadows, OfALightAtTheViewerAreNotTraced) {
  // A screen before the wall, in view: what it hides from the viewer is what it would shadow.
  const scene::MeshPtr before = test::parallelogram({0, 0, 2}, {0.3f, 0, 0}, {0, 0.3f, 0});
  scene::Snapshot s = test::litView({test::wall(), before}, Shader::fixedFunction, {0, 0, 0, 1});
  s.settings.shadows.size = 30;
  for (const float share : sharesOf(s)) EXPECT_EQ(share, 1);
  s.camera.clipFromEye = glm::ortho(-2.0, 2.0, -2.0, 2.0, 0.1, 1000.0);
  test::setLight(s, Shader::phong, {0, 0, 1, 0});
  for (const float share : sharesOf(s)) EXPECT_EQ(share, 1);
}

TEST(Shadows, OfSpheresAreRoundAndFallOnThem) {
  auto sphere = std::make_shared<scene::Mesh>();
  sphere->shape = scene::Shape::spheres;
  sphere->vertexCount = sphere->triangleCount = 1;
  sphere->positions = test::makeAttribute<glm::vec3>({{2, 0, 2}}, scene::Format::float3);
  sphere->radius = 0.5f;
  sphere->lower = {1.5f, -0.5f, 1.5f}, sphere->upper = {2.5f, 0.5f, 2.5f};
  scene::Snapshot s = test::litView({test::wall(), sphere}, Shader::phong, kFromTheRight);
  // The light through the centre meets the wall at the origin; the shadow is 1 / cos(45) wide along x.
  const std::vector<float> along = sharesOf(s);
  for (int x = 0; x < kLitSize; ++x) {
    const float at = test::wallAt(x), y = test::wallAt(kLitSize / 2);
    const float inside = at * at / 2 + y * y;
    if (std::abs(inside - 0.25f) > 0.01f) {
      EXPECT_EQ(along[static_cast<size_t>(x)], inside > 0.25f ? 1 : 0) << x;
    }
  }
}

/// An upright cylinder of this many sides about the origin.
scene::MeshPtr cylinder(int sides, bool smooth) {
  test::MeshData data;
  const auto at = [&](int i, float y) {
    const double a = 2 * M_PI * (i + 0.37) / sides;
    return glm::vec3(std::cos(a), y, std::sin(a));
  };
  for (int i = 0; i < sides; ++i)
    for (const glm::vec3& p :
         {at(i, -50), at(i + 1, -50), at(i + 1, 50), at(i, -50), at(i + 1, 50), at(i, 50)}) {
      data.positions.push_back(p);
      data.normals.push_back(glm::vec3(p.x, 0, p.z));
    }
  if (!smooth) data.normals.clear();
  return test::makeMesh(data);
}

TEST(Shadows, DoNotCutIntoCoarseSmoothConvexSurfaces) {
  for (const int sides : {6, 12, 48, 1000})
    for (const float height : {0.0f, 1.0f}) {
      scene::Snapshot s = test::litView({cylinder(sides, true)}, Shader::fixedFunction, {1, height, 0.2f, 0});
      const Traced shadowed = test::trace(s);
      s.settings.shadows.enabled = false;
      const Traced plain = test::trace(s);
      float most = 0, brightest = 0;
      for (int y = 0; y < kLitSize; ++y)
        for (int x = 0; x < kLitSize; ++x)
          if (plain.hit(x, y)) {
            most = std::max(most, plain.color(x, y).g - shadowed.color(x, y).g);
            brightest = std::max(brightest, plain.color(x, y).g);
          }
      EXPECT_GT(brightest, 150);
      EXPECT_LE(most, 3) << sides << " sides";
    }
}

TEST(Shadows, FadeWhereTrianglesTurnAwayThatNormalsDoNot) {
  // A wall of one triangle pair whose normals all lean to the right; the light goes down from there to the
  // wall's own plane.
  test::MeshData data = test::quadData({-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0});
  data.normals.assign(4, glm::normalize(glm::vec3(1, 0, 1)));
  float before = 1;
  for (const float degrees : {60.0f, 30.0f, 8.0f, 6.0f, 5.0f, 4.0f, 3.0f, 2.0f, 1.0f, 0.3f, 0.0f, -5.0f}) {
    const float e = glm::radians(degrees);
    const float share = sharesOf(
        test::litView({test::makeMesh(data)}, Shader::fixedFunction, {std::cos(e), 0, std::sin(e), 0}))[32];
    EXPECT_LE(share, before) << degrees;
    EXPECT_LT(before - share, 0.3f) << degrees;
    if (degrees > 9) { EXPECT_EQ(share, 1) << degrees; }
    before = share;
  }
  EXPECT_EQ(before, 0) << "no light comes through";
}

}  // namespace
}  // namespace gluray::render
