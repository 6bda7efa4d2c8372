// Materials of settings in the path tracer: mirrors, glass, furnaces.
#include "base/sanitized.h"
#include "base/testing/temporary_folder.h"
#include "render/testing/path_scenes.h"

#include <fstream>
#include <string>

namespace gluray::render {
namespace {

using test::Radiances;
using test::radiances;

constexpr SurfaceMaterial kLossless[] = {SurfaceMaterial::glass, SurfaceMaterial::thinGlass,
                                         SurfaceMaterial::mirror, SurfaceMaterial::plastic,
                                         SurfaceMaterial::program};

TEST(PathMaterials, WhiteLosslessBodiesVanishInAWhiteSky) {
  for (const SurfaceMaterial kind : kLossless)
    for (const float roughness : {0.0f, 0.5f}) {
      if (kind == SurfaceMaterial::glass && roughness > 0) continue;  // loses what meets two facets
      scene::Snapshot s = test::pathView({test::ballMesh(60)});
      s.settings.material.kind = kind;
      s.settings.material.roughness = roughness;
      s.settings.path.depth = 64;
      const Radiances image = radiances(s);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(image.mean()[c], 1, 0.01f) << int(kind) << ' ' << roughness;
    }
}

TEST(PathMaterials, NoMaterialMakesLight) {
  GLURAY_RELEASE_ONLY();
  for (int kind = 0; kind <= static_cast<int>(SurfaceMaterial::principled); ++kind)
    for (const float roughness : {0.0f, 0.3f, 1.0f}) {
      scene::Snapshot s = test::pathView({test::backWall(), test::ballMesh(20, 1, {0, 0, 1})});
      s.settings.material.kind = static_cast<SurfaceMaterial>(kind);
      s.settings.material.roughness = roughness;
      s.settings.material.metallic = 0.5f, s.settings.material.transmission = 0.3f;
      s.settings.material.coat = 0.5f;
      s.settings.path.samples = 64, s.settings.path.depth = 32;
      const glm::vec3 mean = radiances(s).mean();
      for (int c = 0; c < 3; ++c) {
        EXPECT_TRUE(std::isfinite(mean[c]));
        EXPECT_LE(mean[c], 1.01f) << kind << ' ' << roughness;
        EXPECT_GE(mean[c], 0.1f) << kind << ' ' << roughness;
      }
    }
}

/// A view of `mesh` in front of a wall that emits red on the left of x = `edge` and green on the right.
scene::Snapshot beforeColors(const scene::MeshPtr& mesh, float edge) {
  scene::Snapshot s =
      test::pathView({mesh, test::parallelogram({edge - 500, 0, -2}, {500, 0, 0}, {0, 500, 0}),
                      test::parallelogram({edge + 500, 0, -2}, {500, 0, 0}, {0, 500, 0})});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 16, s.settings.path.samples = 64;
  s.camera.clipFromEye = glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.1, 100.0);
  const glm::vec4 colors[] = {{1, 0, 0, 1}, {0, 1, 0, 1}};
  for (size_t i = 0; i < 2; ++i) {
    scene::Instance& wall = s.instances[1 + i];
    wall.shading = 1;  // unlit: stays as it is, whatever the material of lit surfaces
    wall.color = colors[i];
  }
  s.shadings.push_back(s.shadings[0]);
  s.shadings[1].lighting = false;
  return s;
}

/// A box about the origin, `thick` deep, turned about y.
scene::MeshPtr slab(float thick, float degrees) {
  const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0));
  const auto at = [&](float x, float y, float z) { return glm::vec3(turn * glm::vec4(x, y, z, 1)); };
  test::MeshData data;
  const float d = thick / 2, w = 20;
  const glm::vec3 p[] = {at(-w, -w, -d), at(w, -w, -d), at(w, w, -d), at(-w, w, -d),
                         at(-w, -w, d),  at(w, -w, d),  at(w, w, d),  at(-w, w, d)};
  const int quads[6][4] = {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                           {2, 3, 7, 6}, {0, 4, 7, 3}, {1, 2, 6, 5}};
  for (const auto& q : quads)
    for (const int k : {0, 1, 2, 0, 2, 3}) data.positions.push_back(p[q[k]]);
  return test::makeMesh(data);
}

/// The column of pixels where the image's red turns to green.
float edgeOf(const Radiances& image) {
  double red = 0, all = 0;
  for (int y = 12; y < 20; ++y)
    for (int x = 0; x < test::kPathSize; ++x) {
      const glm::vec3 c = image.at(x, y);
      red += double{c.r}, all += double{c.r} + double{c.g};
    }
  return static_cast<float>(red / all * 2 - 1);
}

TEST(PathMaterials, ATurnedGlassSlabShiftsWhatIsBehindItAsSnellSays) {
  // Light keeps its direction and is moved sideways by d sin(a - b) / cos(b), sin(a) = n sin(b).
  const float thick = 1, degrees = 40;
  const double a = glm::radians(double{degrees}), b = std::asin(std::sin(a) / 1.5);
  const auto shift = static_cast<float>(double{thick} * std::sin(a - b) / std::cos(b));
  for (const float sign : {1.0f, -1.0f}) {
    scene::Snapshot s = beforeColors(slab(thick, sign * degrees), 0);
    s.settings.material.kind = SurfaceMaterial::glass;
    s.settings.material.roughness = 0;
    // Turned by a positive angle, the slab bends rays to -x, and shows what is there farther right. The view
    // is a fifth of a unit wide about where the edge must appear: a pixel is 0.006 wide.
    const auto look = [&](float center) {
      const double c{center};
      s.camera.clipFromEye = glm::ortho(c - 0.1, c + 0.1, -0.1, 0.1, 0.1, 100.0);
      return edgeOf(radiances(s)) * 0.1f;
    };
    EXPECT_NEAR(look(sign * shift), 0, 0.004f);
    s.settings.material.kind = SurfaceMaterial::thinGlass;
    EXPECT_NEAR(look(0), 0, 0.004f);
  }
}

TEST(PathMaterials, ASlabTransmitsWhatFresnelLeaves) {
  scene::Snapshot s = beforeColors(slab(1, 0), 400);  // red all over
  s.settings.material.kind = SurfaceMaterial::glass;
  s.settings.material.roughness = 0;
  // Both faces reflect 4 %, again and again: (1 - r) / (1 + r).
  EXPECT_NEAR(radiances(s).mean().r, 0.96f / 1.04f, 0.006f);
  s.settings.material.kind = SurfaceMaterial::thinGlass;
  const float once = 2 * 0.04f / 1.04f;
  EXPECT_NEAR(radiances(s).mean().r, (1 - once) / (1 + once), 0.006f) << "two panes";
}

TEST(PathMaterials, GlassAbsorbsByTheWayThroughIt) {
  scene::Snapshot s = beforeColors(slab(1, 0), 400);
  s.settings.material.kind = SurfaceMaterial::glass;
  s.settings.material.roughness = 0;
  s.settings.material.ior = 1.0001f;
  test::setAlbedo(s.instances[0], glm::vec3(0.5f));
  EXPECT_NEAR(radiances(s).mean().r, 0.5f, 2e-3f) << "without absorption the two surfaces have the colour";
  const float diagonal = std::sqrt(2000.0f * 2000 + 1000 * 1000 + 2.5f * 2.5f);  // of walls and slab
  s.settings.material.absorption = 2 / diagonal;  // colour after a way of 2; the slab is 1 thick
  EXPECT_NEAR(radiances(s).mean().r, std::sqrt(0.5f), 5e-3f);
}

TEST(PathMaterials, AMirrorShowsWhatIsBesideTheViewer) {
  // Turned by 45 degrees about y it looks along x.
  scene::Snapshot s = beforeColors(slab(0.01f, 45), 0);
  for (size_t i : {size_t{1}, size_t{2}}) {
    const float x = i == 1 ? -30 : 30;
    s.instances[i].mesh = test::parallelogram({x, 0, 0}, {0, 500, 0}, {0, 0, 500});
  }
  s.settings.material.kind = SurfaceMaterial::mirror;
  const glm::vec3 seen = radiances(s).mean();
  EXPECT_NEAR(seen.r, 0, 1e-4f);
  EXPECT_NEAR(seen.g, 1, 1e-4f);
}

TEST(PathMaterials, MetalsHaveTheirColour) {
  scene::Snapshot s = test::pathView({test::backWall()});
  s.settings.material.kind = SurfaceMaterial::metal;
  s.settings.material.metal = SurfaceMetal::gold;
  s.settings.material.roughness = 0;
  s.camera.clipFromEye = glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.1, 100.0);
  const glm::vec3 gold = radiances(s).mean();
  EXPECT_NEAR(gold.r, 0.945f, 3e-3f);
  EXPECT_GT(gold.g, gold.b + 0.3f);
}

/// A wall of 0.5, 0.25, 0 before the viewer, and one of any colour behind the viewer that faces it; each is
/// far wider than they are apart. By the file of rules the one with number `emitter` gives off light.
scene::Snapshot betweenWalls(int emitter) {
  scene::Snapshot s = test::pathView({test::parallelogram({0, 0, -2}, {500, 0, 0}, {0, 500, 0}),
                                      test::parallelogram({0, 0, 7}, {500, 0, 0}, {0, 500, 0})});
  s.settings.environment.strength = 0;
  s.camera.clipFromEye = glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.1, 100.0);
  test::setAlbedo(s.instances[0], {0.5f, 0.25f, 0});
  test::setAlbedo(s.instances[1], glm::vec3(1));
  for (uint32_t i = 0; i < 2; ++i) s.instances[i].order = i;
  static const test::TemporaryFolder folder;
  const std::string name = std::to_string(emitter);
  s.settings.material.file = folder.write(
      name + ".toml", "[[rule]]\nobjects = [" + name + "]\nmaterial = \"emissive\"\nemission = 3\n");
  return s;
}

TEST(PathMaterials, EmissiveSurfacesShowTheirColourTimesTheirStrength) {
  for (const LightIntegrator integrator : {LightIntegrator::path, LightIntegrator::whitted}) {
    scene::Snapshot s = betweenWalls(0);
    s.settings.integrator = integrator;
    const glm::vec3 seen = radiances(s).mean();
    EXPECT_NEAR(seen.r, 1.5f, 1e-5f);
    EXPECT_NEAR(seen.g, 0.75f, 1e-5f);
    EXPECT_EQ(seen.b, 0);
  }
}

TEST(PathMaterials, EmissiveSurfacesLightOthersAndReflectNothing) {
  // Radiance 3 fills half of the sky of the wall before it; what that wall reflects is lost at the emitter.
  const glm::vec3 seen = radiances(betweenWalls(1)).mean();
  EXPECT_NEAR(seen.r, 1.5f, 0.01f);
  EXPECT_NEAR(seen.g, 0.75f, 0.01f);
  EXPECT_EQ(seen.b, 0);
}

TEST(PathMaterials, LightsShineStraightThroughGlass) {
  scene::Snapshot s =
      test::pathView({test::backWall(), test::parallelogram({0, 0, 100}, {90, 0, 0}, {0, 90, 0})});
  s.settings.environment.strength = 0;
  s.settings.path.depth = 1;
  scene::Light light;
  light.position = {0.2f, 0, 1, 0}, light.diffuse = glm::vec4(1);
  s.shadings[0].lights = {light};
  EXPECT_NEAR(radiances(s).mean().r, 0, 1e-6f);
  s.settings.material.kind = SurfaceMaterial::thinGlass;
  s.settings.path.depth = 4;
  EXPECT_NEAR(radiances(s).mean().r, 0, 1e-6f) << "the wall is glass, too";
}

}  // namespace
}  // namespace gluray::render
