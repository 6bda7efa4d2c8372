// Textures of surfaces that paths meet after a bounce: how wide pixels are there.
#include "render/paths/ray_cone.h"
#include "render/testing/path_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gluray::render {
namespace {

using test::kPathSize;
using test::radiances;

/// Two by two squares, black and white, of 32 x 32 texels, down to one grey texel.
scene::Texture checkerboard(bool filtered) {
  auto image = std::make_shared<scene::TextureImage>();
  image->baseFormat = scene::BaseFormat::rgb;
  const auto fill = [](scene::TexelGrid& grid, int side) {
    grid.width = grid.height = side;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        grid.texels.push_back(side == 1                          ? 0xFF808080u
                              : (x < side / 2) == (y < side / 2) ? 0xFFFFFFFFu
                                                                 : 0xFF000000u);
  };
  fill(*image, 64);
  image->mipmaps.resize(filtered ? 6 : 0);
  for (size_t i = 0; i < image->mipmaps.size(); ++i) fill(image->mipmaps[i], 32 >> i);
  scene::Texture t;
  t.image = image;
  t.mipFilter = filtered ? scene::MipFilter::linear : scene::MipFilter::none;
  if (!filtered) t.magFilter = t.minFilter = scene::Filter::nearest;
  return t;
}

/// A floor of checkerboards that the camera at z = 5 sees: straight, from z = -6 on; or, behind the viewer,
/// in a mirror at z = 0.
scene::Snapshot viewOf(const test::MeshData& textured, bool mirrored, bool filtered) {
  std::vector<scene::MeshPtr> meshes{test::makeMesh(textured)};
  if (mirrored) meshes.push_back(test::backWall());
  scene::Snapshot s = test::pathView(meshes);
  s.shadings.push_back(s.shadings[0]);
  s.shadings[1].lighting = false;
  s.shadings[1].textures = {checkerboard(filtered)};
  s.instances[0].shading = 1;
  s.settings.material.kind = SurfaceMaterial::mirror;  // of lit surfaces
  s.settings.environment.strength = 0;
  s.settings.path.samples = 1;
  return s;
}

/// A floor of checkerboards from z = -6 on, or from 6 on.
scene::Snapshot floorView(bool mirrored, bool filtered) {
  const float side = mirrored ? 1 : -1;
  test::MeshData floor =
      test::quadData({-60, -2, side * 6}, {60, -2, side * 6}, {60, -2, side * 400}, {-60, -2, side * 400});
  for (const glm::vec3& p : floor.positions) floor.texcoords.emplace_back(p.x / 2, std::abs(p.z) / 2, 0, 1);
  return viewOf(floor, mirrored, filtered);
}

/// Root mean square of the difference in pixels below the horizon.
double apart(const test::Radiances& a, const test::Radiances& b) {
  double sum = 0;
  int count = 0;
  for (int y = 0; y < kPathSize / 2 - 1; ++y)
    for (int x = 0; x < kPathSize; ++x, ++count) sum += std::pow(a.at(x, y).g - b.at(x, y).g, 2);
  return std::sqrt(sum / count);
}

TEST(PathTextures, InMirrorsAreFilteredAsThoseSeenStraight) {
  const auto straight = radiances(floorView(false, true)), mirrored = radiances(floorView(true, true));
  EXPECT_GT(straight.mean().g, 0.4f);
  EXPECT_LT(apart(straight, mirrored), 0.03);
}

TEST(PathTextures, InMirrorsAreAsFarAwayAsTheWayOfTheLight) {
  // A wall one behind the viewer, which the mirror shows at a distance of 11.
  const auto wall = [](bool mirrored) {
    const float z = mirrored ? 6 : -6;
    test::MeshData data = test::quadData({-50, -50, z}, {50, -50, z}, {50, 50, z}, {-50, 50, z});
    for (const glm::vec3& p : data.positions) data.texcoords.emplace_back(9 * p.x, 9 * p.y, 0, 1);
    return viewOf(data, mirrored, true);
  };
  const auto straight = radiances(wall(false)), mirrored = radiances(wall(true));
  EXPECT_GT(straight.mean().g, 0.3f);
  EXPECT_LT(apart(straight, mirrored), 0.03);
}

TEST(PathTextures, InMirrorsAreNearTheMeanOfManyRays) {
  scene::Snapshot s = floorView(true, false);
  const auto single = radiances(s);
  s.settings.spp = 256;
  const auto many = radiances(s), filtered = radiances(floorView(true, true));
  EXPECT_GT(apart(single, many), 0.3) << "one ray a pixel flickers";
  EXPECT_LT(apart(filtered, many), 0.15);
  // Far away, all is grey.
  for (int x = 0; x < kPathSize; ++x) EXPECT_NEAR(filtered.at(x, kPathSize / 2 - 2).g, 0.5f, 0.03f);
}

TEST(PathTextures, SeenByDiffuseSurfacesGiveTheirMean) {
  for (const bool filtered : {false, true}) {
    scene::Snapshot s = floorView(true, filtered);
    s.settings.material.kind = SurfaceMaterial::program;
    s.settings.path.samples = 256, s.settings.path.depth = 2;
    static float plain = 0;
    const float mean = radiances(s).mean().g;
    if (!filtered) plain = mean;
    EXPECT_NEAR(mean, plain, 0.003f);
    EXPECT_GT(mean, 0.05f);
  }
}

/// One texel.
scene::Texture plain(const glm::vec4& color) {
  auto image = std::make_shared<scene::TextureImage>();
  image->width = image->height = 1;
  image->floats = {color};
  scene::Texture t;
  t.image = image;
  return t;
}

/// Pixels of the encoded images that differ by more.
int pixelsApart(const test::Radiances& a, const test::Radiances& b, float most) {
  int count = 0;
  for (int y = 0; y < kPathSize; ++y)
    for (int x = 0; x < kPathSize; ++x) {
      const glm::vec3 apart = glm::abs(glm::vec3(a.at(x, y)) - glm::vec3(b.at(x, y)));
      count += std::max({apart.x, apart.y, apart.z}) > most;
    }
  return count;
}

/// Base colour, roughness, metallic share, emission and normals of paths are those of the local look.
TEST(PathTextures, OfPhysicallyBasedMaterialsAreThoseOfTheLocalLook) {
  scene::Snapshot s = test::pathView({test::ballMesh(60)});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 1, s.settings.path.samples = 64;
  scene::FragmentShading& f = s.shadings[0].fragment;
  f.model = scene::FragmentShading::Model::pbr, f.texturesFirst = true;
  f.lights.resize(1);
  f.lights[0].color = glm::vec3(3);
  s.instances[0].lightingFromObject = glm::mat4(s.instances[0].eyeFromObject);
  s.instances[0].materials[0].front.diffuse = glm::vec4(1);
  s.instances[0].texcoordsAbove = {glm::vec4(0, 0, 0, 1), glm::vec4(0.3f, 1, 0.2f, 1)};
  s.shadings[0].textures = {plain({0.7f, 0.5f, 0.3f, 1})};
  f.pbr.metallic = 1, f.pbr.roughness = 1, f.pbr.emissive = {0.4f, 0.2f, 0};
  f.pbr.textures = {plain({1, 0.5f, 0.6f, 1}), plain({0.5f, 0.25f, 1, 1}), plain({0.6f, 0.45f, 0.95f, 1})};
  f.pbr.material = 0, f.pbr.emission = 1;
  for (const int normal : {-1, 2}) {
    f.pbr.normal = normal;
    scene::Snapshot look = s;
    look.settings.integrator = LightIntegrator::local;
    // At the rim, paths turn mapped normals that point away from the viewer.
    EXPECT_LE(pixelsApart(radiances(s), radiances(look), 6e-3f), normal < 0 ? 0 : 1);
  }
}

TEST(RayCone, IsAsWideAsThePixel) {
  const scene::Snapshot s = floorView(false, true);
  const RaySetup setup = makeRaySetup(s, glm::vec3(-1), glm::vec3(1)), eye = makeEyeRays(s, setup);
  const RayCone cone = coneAt(eye, 16, 16, {0, 0, -5});
  const float pixel = 2 * std::tan(glm::radians(20.0f)) / kPathSize;
  EXPECT_NEAR(cone.spread, pixel, 1e-4f);
  EXPECT_NEAR(cone.width, 5 * pixel, 1e-3f);
  EXPECT_NEAR(cone.widthAt(5), 10 * pixel, 1e-3f);
}

TEST(RayCone, StepsAreThePixelOnTheTriangle) {
  const glm::dvec3 corner[] = {{0, 0, 0}, {2, 0, 0}, {0, 4, 0}};
  // At 60 degrees to the normal, along x: twice as long as wide.
  const WeightSteps steps = stepsOn(corner, {-std::sqrt(0.75), 0, 0.5}, 0.1);
  EXPECT_NEAR(std::abs(steps.x[1]), 0.2 / 2, 1e-9);
  EXPECT_NEAR(steps.x[2], 0, 1e-9);
  EXPECT_NEAR(std::abs(steps.y[2]), 0.1 / 4, 1e-9);
  EXPECT_NEAR(steps.x[0] + steps.x[1] + steps.x[2], 0, 1e-12);
  const glm::dvec3 none[] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(stepsOn(none, {0, 0, 1}, 1).x, glm::dvec3(0));
}

}  // namespace
}  // namespace gluray::render
