// look = honest: exactly the program's colours, whatever light it has.
#include "render/testing/test_trace.h"

#include <gtest/gtest.h>

namespace gluray::render {
namespace {

using Fragment = scene::FragmentShading;

/// A lit square with a colour of its own for every column of pixels, as a colour map gives: all bytes.
scene::Snapshot colouredColumns() {
  test::MeshData data;
  for (int x = 0; x < 16; ++x) {
    const auto left = static_cast<float>(x) / 8 - 1, right = left + 1.0f / 8;
    const auto v = static_cast<float>(16 * x + 7) / 255;
    for (const glm::vec2 p : {glm::vec2(left, -1), glm::vec2(right, -1), glm::vec2(right, 1),
                              glm::vec2(left, -1), glm::vec2(right, 1), glm::vec2(left, 1)}) {
      data.positions.emplace_back(p, 0.3f * p.x);
      data.normals.emplace_back(0.3f, 0.1f, 0.9f);
      data.colors.emplace_back(v, 1 - v, 0.2f, 1);
    }
  }
  scene::Snapshot s = test::makeSnapshot({test::makeMesh(data)});
  s.shadings[0].lighting = true;
  scene::Light light;
  light.ambient = {0.1f, 0.2f, 0.3f, 1};
  light.diffuse = {0.9f, 0.8f, 0.5f, 1};
  light.specular = {1, 1, 1, 1};
  s.shadings[0].lights = {light};
  s.shadings[0].fog.mode = scene::Fog::exp;
  s.shadings[0].fog.color = {1, 0, 0};
  scene::Material& m = s.instances[0].materials[0].front;
  m.specular = {1, 1, 1, 1}, m.shininess = 3, m.emission = {0.1f, 0, 0.2f, 1};
  return s;
}

void expectColumns(const scene::Snapshot& s, const char* what) {
  const test::Traced traced = test::trace(s);
  for (int x = 0; x < 16; ++x)
    EXPECT_EQ(traced.color(x, 5), glm::vec4(16 * x + 7, 255 - (16 * x + 7), 51, 255)) << what << " " << x;
}

TEST(HonestLook, ShowsVertexColoursExactly) {
  for (const auto mode : {scene::ColorMaterial::diffuse, scene::ColorMaterial::ambientAndDiffuse}) {
    scene::Snapshot s = colouredColumns();
    s.shadings[0].colorMaterial = {mode, mode};
    EXPECT_NE(test::trace(s).color(9, 5), glm::vec4(151, 104, 51, 255)) << "lit colours differ";
    s.settings.look = Look::honest;
    expectColumns(s, "lit");
    s.settings.shading = ShadingRate::vertex;
    expectColumns(s, "lit at vertices");
    s.shadings[0].lighting = false;
    expectColumns(s, "unlit");
  }
}

TEST(HonestLook, ShowsTheDiffuseMaterial) {
  scene::Snapshot s = colouredColumns();
  s.settings.look = Look::honest;
  s.instances[0].materials[0].front.diffuse = {0.2f, 0.4f, 0.6f, 1};
  for (const auto mode : {scene::ColorMaterial::off, scene::ColorMaterial::ambient,
                          scene::ColorMaterial::specular, scene::ColorMaterial::emission}) {
    s.shadings[0].colorMaterial = {mode, mode};
    EXPECT_EQ(test::trace(s).color(3, 3), glm::vec4(51, 102, 153, 255));
  }
}

TEST(HonestLook, ShowsProgramsColoursExactly) {
  scene::Snapshot s = colouredColumns();
  s.settings.look = Look::honest;
  Fragment& fragment = s.shadings[0].fragment;
  fragment.lights.resize(1);
  fragment.color = Fragment::Color::vertices;
  scene::Material& m = s.instances[0].materials[0].front;
  m.ambient = {0.3f, 0.3f, 0.3f, 1}, m.diffuse = {0.7f, 0.7f, 0.7f, 1};
  for (const auto model : {Fragment::Model::phong, Fragment::Model::pbr, Fragment::Model::unlit}) {
    fragment.model = model;
    expectColumns(s, "program");
  }
  fragment.color = Fragment::Color::material;
  m.diffuse = {0.2f, 0.4f, 0.6f, 1};
  EXPECT_EQ(test::trace(s).color(3, 3), glm::vec4(51, 102, 153, 255));
}

TEST(HonestLook, NoEffectChangesIt) {
  scene::Snapshot s = colouredColumns();
  s.shadings[0].colorMaterial = {scene::ColorMaterial::diffuse, scene::ColorMaterial::diffuse};
  s.settings.look = Look::honest;
  s.settings.ao.enabled = true;
  s.settings.exposure = 2;
  s.settings.tone = Tone::aces;
  expectColumns(s, "with effects");
}

TEST(HonestLook, IsOffByDefault) {
  scene::Snapshot s = colouredColumns();
  const Image before = test::trace(s).image;
  s.settings.look = Look::honest;
  EXPECT_NE(test::trace(s).image.color, before.color);
  s.settings.look = Look::program;
  EXPECT_EQ(test::trace(s).image.color, before.color);
}

}  // namespace
}  // namespace gluray::render
