// What paths meet on their way: impostors, translucent surfaces, what clip planes cut away, edges, textures.
#include "base/sanitized.h"
#include "render/testing/path_scenes.h"

namespace gluray::render {
namespace {

using test::radiances;

scene::MeshPtr impostor(scene::Shape shape, const glm::vec3& center, float radius) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->shape = shape;
  mesh->vertexCount = mesh->triangleCount = 1;
  mesh->positions = test::makeAttribute<glm::vec3>({center}, scene::Format::float3);
  mesh->radius = radius;
  mesh->lower = center - radius, mesh->upper = center + radius;
  return mesh;
}

/// Makes instance `i` a program's white Phong surface without lights.
void shadeByProgram(scene::Snapshot& s, size_t i) {
  s.instances[i].shading = static_cast<uint32_t>(s.shadings.size());
  s.shadings.push_back(s.shadings[0]);
  s.shadings.back().fragment.model = scene::FragmentShading::Model::phong;
  s.instances[i].lightingFromObject = glm::mat4(s.instances[i].eyeFromObject);
  s.instances[i].materials[0].front.ambient = s.instances[i].materials[0].back.ambient = {0, 0, 0, 1};
}

TEST(PathSurfaces, ImpostorsAreSolids) {
  GLURAY_RELEASE_ONLY();
  scene::Snapshot s = test::pathView({test::backWall(), impostor(scene::Shape::spheres, {0, 0, 1.5f}, 1)});
  shadeByProgram(s, 1);
  s.settings.path.depth = 64;
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(radiances(s).mean()[c], 1, 0.005f) << "white in a white sky";
  // A black ball hides its form factor of the sky from the wall straight below it.
  s = test::pathView({test::backWall(), impostor(scene::Shape::spheres, {0, 0, 12}, 6)});
  shadeByProgram(s, 1);
  test::setAlbedo(s.instances[1], glm::vec3(0));
  s.camera.clipFromEye = glm::perspective(glm::radians(0.5), 1.0, 0.1, 1000.0);
  EXPECT_NEAR(radiances(s).mean().g, 1 - 36.0f / 144, 0.004f);
  // A ball that shines gives the wall as much.
  s.settings.environment.strength = 0;
  s.instances[1].materials[0].front.ambient = {1, 1, 1, 1};
  EXPECT_NEAR(radiances(s).mean().g, 36.0f / 144, 0.004f);
}

TEST(PathSurfaces, SticksShineInTheColorsOfBothEnds) {
  GLURAY_RELEASE_ONLY();
  float brightness[2];
  for (int k = 0; k < 2; ++k) {
    auto mesh = std::make_shared<scene::Mesh>();
    mesh->shape = scene::Shape::sticks;
    mesh->triangleCount = 1, mesh->vertexCount = 2, mesh->radius = 3;
    mesh->positions = test::makeAttribute<glm::vec3>({{-6, 0, 8}, {6, 0, 8}}, scene::Format::float3);
    const glm::vec4 black(0, 0, 0, 1), white(1);
    mesh->colors = test::makeAttribute<glm::vec4>({k == 0 ? black : white, k == 0 ? white : black},
                                                  scene::Format::float4);
    mesh->ends = test::makeAttribute<uint32_t>({scene::kClosedEnd | scene::kTwoHalves, scene::kClosedEnd},
                                               scene::Format::uint32);
    mesh->lower = {-6, 0, 8}, mesh->upper = {6, 0, 8};
    mesh->geometryId = hashBytes(&k, sizeof k);
    scene::Snapshot s = test::pathView({test::backWall(), mesh});
    shadeByProgram(s, 1);
    s.shadings[s.instances[1].shading].fragment.color = scene::FragmentShading::Color::vertices;
    s.instances[1].materials[0].front.ambient = {1, 1, 1, 1};
    s.camera.clipFromEye = glm::perspective(glm::radians(0.5), 1.0, 0.1, 1000.0);
    s.settings.environment.strength = 0;
    brightness[k] = radiances(s).mean().g;
  }
  EXPECT_GT(brightness[0], 0.02f);
  EXPECT_NEAR(brightness[0], brightness[1], 0.01f);
}

/// A bead or a tube along x, 24 of 32 pixels wide, under a light at the viewer.
scene::Snapshot sizedInPixels(scene::Shape shape) {
  auto mesh = std::make_shared<scene::Mesh>();
  const bool tube = shape == scene::Shape::tubes;
  mesh->shape = shape;
  mesh->triangleCount = 1, mesh->vertexCount = tube ? 2 : 1;
  std::vector<glm::vec3> points{{tube ? -1.0f : 0.0f, 0, 0}};
  if (tube) points.emplace_back(1, 0, 0);
  mesh->lower = points.front(), mesh->upper = points.back();
  mesh->positions = test::makeAttribute(std::move(points), scene::Format::float3);
  scene::Snapshot s = test::pathView({mesh});
  s.instances[0].lightingFromObject = glm::mat4(s.instances[0].eyeFromObject);
  s.instances[0].impostors.size = glm::vec2(1.5f);
  // So narrow that lines of sight are parallel.
  s.camera.clipFromEye = glm::perspective(glm::radians(0.5), 1.0, 0.1, 1000.0);
  s.settings.environment.strength = 0;
  s.settings.path.samples = 4;
  scene::Light light;
  light.position = {0, 0, 1, 0}, light.diffuse = glm::vec4(1);
  s.shadings[0].lights = {light};
  return s;
}

TEST(PathSurfaces, BeadsAndTubesAreRound) {
  for (const scene::Shape shape : {scene::Shape::beads, scene::Shape::tubes}) {
    const test::Radiances r = radiances(sizedInPixels(shape));
    for (const int x : {12, 16, 19})
      for (int y = 6; y < 26; ++y) {
        const auto at = [](int pixel) { return (static_cast<float>(pixel) - 15.5f) / 12; };
        const float across = at(y), along = shape == scene::Shape::beads ? at(x) : 0;
        const float rest = 1 - across * across - along * along;
        if (rest < 0.1f) continue;
        ASSERT_TRUE(r.hit(x, y));
        EXPECT_NEAR(r.at(x, y).g, std::sqrt(rest), 0.01f) << static_cast<int>(shape) << ": " << x << ' ' << y;
      }
  }
}

/// A wall under a black lid that hides all of its sky.
scene::Snapshot underLid() {
  scene::Snapshot s =
      test::pathView({test::backWall(), test::parallelogram({0, 0, 50}, {9e3f, 0, 0}, {0, 9e3f, 0})});
  s.settings.path.depth = 1;
  test::setAlbedo(s.instances[1], glm::vec3(0));
  return s;
}

TEST(PathSurfaces, WhatClipPlanesCutAwayIsNotThere) {
  scene::Snapshot s = underLid();
  EXPECT_NEAR(radiances(s).mean().g, 0, 0.01f);
  s.instances[1].clipPlanes = {{0, 0, -1, 20}};  // eye space: keeps z <= 20, and the lid is at 45
  EXPECT_NEAR(radiances(s).mean().g, 1, 1e-4f);
  s.instances[0].clipPlanes = s.instances[1].clipPlanes;
  EXPECT_NEAR(radiances(s).mean().g, 1, 1e-4f);
}

/// Mean brightness of the image's green bytes.
float middle(const scene::Snapshot& s) {
  const test::Traced traced = test::trace(s);
  float sum = 0;
  for (int y = 0; y < test::kPathSize; ++y)
    for (int x = 0; x < test::kPathSize; ++x) sum += traced.color(x, y).g / 255;
  return sum / (test::kPathSize * test::kPathSize);
}

TEST(PathSurfaces, TranslucentSurfacesLetThroughWhatTheirAlphaLeaves) {
  for (const float alpha : {0.25f, 0.75f}) {
    scene::Snapshot s = underLid();
    auto layers = std::make_shared<scene::Layers>();
    layers->opaqueDepth.assign(test::kPathSize * test::kPathSize, -1.0f);
    s.layers = layers;
    s.wideColors = false;
    s.instances[1].materials[0].front.diffuse.a = s.instances[1].materials[0].back.diffuse.a = alpha;
    EXPECT_NEAR(middle(s), 1 - alpha, 0.01f) << alpha;
    // A light's ray, too.
    s.settings.environment.strength = 0;
    scene::Light light;
    light.position = {0, 0, 1, 0}, light.diffuse = glm::vec4(1);
    s.shadings[0].lights = {light};
    EXPECT_NEAR(middle(s), 1 - alpha, 0.01f) << alpha;
  }
}

TEST(PathSurfaces, ColoursComeFromVerticesMaterialsAndPrograms) {
  scene::Snapshot s = test::pathView({test::backWall()});
  s.settings.path.samples = 4;
  // glColorMaterial follows the current colour.
  s.instances[0].color = {0.2f, 0.4f, 0.6f, 1};
  s.shadings[0].colorMaterial = {scene::ColorMaterial::diffuse, scene::ColorMaterial::diffuse};
  EXPECT_NEAR(radiances(s).mean().b, 0.6f, 1e-4f);
  s.shadings[0].colorMaterial = {scene::ColorMaterial::emission, scene::ColorMaterial::emission};
  EXPECT_NEAR(radiances(s).mean().b, 1.6f, 1e-4f) << "white, and shines";
  s.shadings[0].colorMaterial = {};
  s.shadings[0].lighting = false;
  EXPECT_NEAR(radiances(s).mean().b, 0.6f, 1e-4f) << "without lighting as it is";
  s.shadings[0].lighting = true;
  s.shadings[0].fragment.model = scene::FragmentShading::Model::phong;
  s.shadings[0].fragment.color = scene::FragmentShading::Color::vertices;
  s.instances[0].materials[0].front.ambient = {0, 0, 0, 1};
  EXPECT_NEAR(radiances(s).mean().g, 0.4f, 1e-4f);
  s.instances[0].materials[0].front.ambient = {0.5f, 0.5f, 0.5f, 1};
  EXPECT_NEAR(radiances(s).mean().g, 0.4f + 0.5f * 0.4f, 1e-4f) << "ambient colours shine";
}

TEST(PathSurfaces, FogLiesOnTheWayFromTheViewerToWhatItSees) {
  // A wall at distance 5, and a mirror that shows another one behind the viewer: both are as foggy as what is
  // at their place, whatever stands beyond the mirror.
  for (const auto kind : {SurfaceMaterial::program, SurfaceMaterial::mirror}) {
    scene::Snapshot s =
        test::pathView({test::backWall(), test::parallelogram({0, 0, 100}, {500, 0, 0}, {0, 500, 0})});
    s.settings.material.kind = kind;
    s.settings.environment.strength = 0, s.settings.path.samples = 4;
    s.shadings.push_back(s.shadings[0]);
    s.shadings[1].lighting = false;
    for (scene::Shading& shading : s.shadings) {
      shading.fog.mode = scene::Fog::linear;
      shading.fog.start = 0, shading.fog.end = 20;
      shading.fog.color = {0, 1, 0};
    }
    s.instances[1].shading = 1, s.instances[1].color = {1, 0, 0, 1};
    if (kind == SurfaceMaterial::program) s.instances[0].shading = 1, s.instances[0].color = {1, 0, 0, 1};
    const glm::vec3 mean = radiances(s).mean();
    EXPECT_NEAR(mean.r, 0.75f, 1e-3f);
    EXPECT_NEAR(mean.g, 0.25f, 1e-3f);
  }
}

TEST(PathSurfaces, ProgramsHaveFogOfTheirOwnEyeSpace) {
  scene::Snapshot s = test::pathView({test::backWall()});
  s.settings.environment.strength = 0, s.settings.path.samples = 4;
  scene::Shading& shading = s.shadings[0];
  shading.fragment.model = scene::FragmentShading::Model::unlit;
  shading.fragment.color = scene::FragmentShading::Color::vertices;
  shading.fog.mode = scene::Fog::linear;
  shading.fog.end = 20, shading.fog.scaled = true, shading.fog.scale = 0.05f;
  shading.fog.color = {0, 1, 0};
  s.instances[0].color = {1, 0, 0, 1};
  s.instances[0].materials[0].front.ambient = {0, 0, 0, 1};
  // The wall at distance 5 is at distance 10 in the program's eye space.
  s.instances[0].lightingFromObject =
      glm::mat4(glm::scale(glm::dmat4(1), glm::dvec3(2)) * s.instances[0].eyeFromObject);
  for (const LightIntegrator integrator : {LightIntegrator::local, LightIntegrator::path}) {
    s.settings.integrator = integrator;
    const glm::vec3 mean = radiances(s).mean();
    EXPECT_NEAR(mean.r, 0.5f, 1e-3f);
    EXPECT_NEAR(mean.g, 0.5f, 1e-3f);
    shading.fog.end = 5, shading.fog.extrapolates = true;
    EXPECT_NEAR(radiances(s).mean().g, 1.25f, 1e-3f) << "beyond the end of the fog";
    shading.fog.end = 20, shading.fog.extrapolates = false;
  }
}

TEST(PathSurfaces, BackFacesHaveTheirOwnMaterial) {
  scene::Snapshot s = test::pathView({test::backWall()});
  s.settings.path.samples = 4;
  s.shadings[0].twoSided = true;
  s.instances[0].materials[0].back.diffuse = {0.25f, 0.25f, 0.25f, 1};
  EXPECT_NEAR(radiances(s).mean().g, 1, 1e-4f);
  s.instances[0].frontFaceCcw = false;
  EXPECT_NEAR(radiances(s).mean().g, 0.25f, 1e-4f);
}

TEST(PathSurfaces, PlacesWithoutLightOrWithoutNormalsAreNumbers) {
  scene::Snapshot s = test::pathView({test::ballMesh(20), test::backWall()});
  test::MeshData flat = test::quadData({-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1});
  flat.normals.assign(4, glm::vec3(0));
  s.instances[1].mesh = test::makeMesh(flat);
  s.instances[1].materials[0].front.diffuse = {std::nanf(""), 1e30f, -1, 1};
  for (const float strength : {0.0f, 1000.0f}) {
    s.settings.environment.strength = strength;
    const auto image = radiances(s);
    for (int y = 0; y < test::kPathSize; ++y)
      for (int x = 0; x < test::kPathSize; ++x)
        if (image.hit(x, y)) {
          const glm::vec3 c = image.at(x, y);
          ASSERT_TRUE(std::isfinite(c.x + c.y + c.z)) << x << ',' << y;
        }
  }
}

}  // namespace
}  // namespace gluray::render
