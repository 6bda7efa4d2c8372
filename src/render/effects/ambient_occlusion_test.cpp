// Ambient occlusion against scenes whose hidden share of the sky is known in closed form.
#include "render/testing/test_ball.h"
#include "render/testing/test_targets.h"
#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gluray::render {
namespace {

constexpr int kOcclusionSize = 32;

/// White, unlit meshes in the view of a camera at (0, 0, 5) that looks at the origin; y is up.
scene::Snapshot occludedView(const std::vector<scene::MeshPtr>& meshes) {
  scene::Snapshot s = test::makeSnapshot(meshes, kOcclusionSize);
  s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5});
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.settings.ao.enabled = true;
  s.settings.ao.samples = 256;
  s.settings.ao.radius = 100;
  return s;
}

/// The wall z = 0 that fills the view.
scene::MeshPtr backWall() { return test::parallelogram({0, 0, 0}, {500, 0, 0}, {0, 500, 0}); }

/// Mean brightness of the pixels, of those that hit, 0 .. 1.
float meanOfHits(const test::Traced& traced, int x0 = 0, int x1 = kOcclusionSize) {
  float sum = 0;
  int count = 0;
  for (int y = 0; y < kOcclusionSize; ++y)
    for (int x = x0; x < x1; ++x)
      if (traced.hit(x, y)) sum += traced.color(x, y).g / 255, ++count;
  EXPECT_GT(count, 0);
  return sum / static_cast<float>(count);
}

TEST(AmbientOcclusion, OfAFlatSurfaceIsNone) {
  const test::Traced traced = test::trace(occludedView({backWall()}));
  for (int i = 0; i < kOcclusionSize; ++i) EXPECT_EQ(traced.color(i, i), glm::vec4(255));
}

TEST(AmbientOcclusion, BesideAnEndlessWallHalfOfTheSkyIsHidden) {
  // The wall x = 3 stands on the test::parallelogram that is seen, beyond the view.
  const test::Traced traced =
      test::trace(occludedView({backWall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})}));
  // With the radius of the scene's diagonal all of the wall counts.
  EXPECT_NEAR(meanOfHits(traced), 0.5f, 0.004f);
  EXPECT_NEAR(traced.color(kOcclusionSize / 2, kOcclusionSize / 2).g / 255, 0.5f, 0.03f);
}

TEST(AmbientOcclusion, UnderASphereIsItsFormFactor) {
  // From a patch straight below its centre a sphere hides (radius / distance)^2 of the cosine-weighted sky.
  auto sphere = std::make_shared<scene::Mesh>();
  sphere->shape = scene::Shape::spheres;
  sphere->vertexCount = sphere->triangleCount = 1;
  sphere->positions = test::makeAttribute<glm::vec3>({{0, 0, 12}}, scene::Format::float3);
  sphere->radius = 6;
  sphere->lower = {-6, -6, 6}, sphere->upper = {6, 6, 18};
  scene::Snapshot s = occludedView({backWall(), sphere});
  s.instances[1].lightingFromObject = glm::mat4(s.instances[1].eyeFromObject);
  s.camera.clipFromEye = glm::perspective(glm::radians(0.5), 1.0, 0.1, 1000.0);
  s.settings.ao.samples = 1024;
  EXPECT_NEAR(meanOfHits(test::trace(s)), 1 - 36.0f / 144, 0.003f);
}

// A surface of triangles much narrower than a pixel: a pixel's point may lie beside the triangle that its ray
// met, behind its neighbour.
TEST(AmbientOcclusion, OfNeedlesIsNeverTotal) {
  constexpr uint32_t kNeedles = 5000;
  constexpr int kSize = 384;
  test::MeshData data;
  for (uint32_t i = 0; i <= kNeedles; ++i) {
    const float x = 2.0f * static_cast<float>(i) / kNeedles - 1;
    data.positions.push_back({x, -0.8f, 0.1f * std::sin(9 * x)});
    data.positions.push_back({x, 0.8f, 0.1f * std::cos(7 * x)});
  }
  for (uint32_t i = 0; i < 2 * kNeedles; i += 2)
    data.indices.insert(data.indices.end(), {i, i + 2, i + 3, i, i + 3, i + 1});
  scene::Snapshot s = occludedView({test::makeMesh(data)});
  s.camera.viewport = {0, 0, kSize, kSize}, s.region = {0, 0, kSize, kSize};
  s.camera.clipFromEye = glm::perspective(glm::radians(25.0), 1.0, 0.1, 1000.0);
  s.eyeFromWorld = glm::rotate(s.eyeFromWorld, 0.4, {1, 0, 0});
  s.instances[0].eyeFromObject = s.eyeFromWorld;
  s.settings.ao.samples = 16;
  const test::Traced traced = test::trace(s);
  int hits = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      hits += traced.hit(x, y);
      EXPECT_TRUE(!traced.hit(x, y) || traced.color(x, y).g > 16) << x << ", " << y;
    }
  EXPECT_GT(hits, 20000);
}

TEST(AmbientOcclusion, ReachesAsFarAsItsRadius) {
  const auto lid = [](float height) { return test::parallelogram({0, 0, height}, {500, 0, 0}, {0, 500, 0}); };
  scene::Snapshot s = occludedView({backWall(), lid(50)});
  const float diagonal = std::sqrt(2 * 1000.0f * 1000 + 50 * 50);
  s.settings.ao.radius = 49.5f / diagonal;
  EXPECT_EQ(meanOfHits(test::trace(s)), 1);
  // Rays within 60 degrees of the normal reach the lid: sin^2(60) of the cosine-weighted sky.
  s.settings.ao.radius = 100 / diagonal;
  EXPECT_NEAR(meanOfHits(test::trace(s)), 0.25f, 0.004f);
}

TEST(AmbientOcclusion, IsAsDarkAsItsStrength) {
  scene::Snapshot s =
      occludedView({backWall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})});
  s.settings.ao.strength = 0.5f;
  EXPECT_NEAR(meanOfHits(test::trace(s)), 0.75f, 0.004f);
  s.settings.ao.strength = 0;
  EXPECT_EQ(meanOfHits(test::trace(s)), 1);
}

/// Fog lies between the viewer and the surface: it is not darkened.
TEST(AmbientOcclusion, ActsBehindFog) {
  for (const bool program : {false, true})
    for (const AmbientOcclusionOn on : {AmbientOcclusionOn::look, AmbientOcclusionOn::ambient}) {
      scene::Snapshot s =
          occludedView({backWall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})});
      s.camera.clipFromEye = glm::perspective(glm::radians(0.5), 1.0, 0.1, 1000.0);
      s.settings.ao.on = on;
      scene::Shading& shading = s.shadings[0];
      shading.globalAmbient = {1, 1, 1, 1};
      shading.lighting = !program;
      if (program) shading.fragment.model = scene::FragmentShading::Model::unlit;
      for (scene::Instance& instance : s.instances) {
        instance.lightingFromObject = glm::mat4(instance.eyeFromObject);
        scene::Material white;
        white.ambient = white.diffuse = {1, 1, 1, 1};
        if (program) white.diffuse = {0, 0, 0, 1};
        instance.materials = {{white, white}};
      }
      shading.fog.mode = scene::Fog::linear;
      shading.fog.color = glm::vec3(0.8f);
      shading.fog.start = 0;
      for (const float end : {5.0f, 10.0f, 20.0f}) {  // the wall is at 5
        shading.fog.end = end;
        const float seen = 1 - 5 / end;
        EXPECT_NEAR(meanOfHits(test::trace(s)), seen * 0.5f + (1 - seen) * 0.8f, 0.01f)
            << program << " " << static_cast<int>(on) << " " << end;
      }
    }
}

TEST(AmbientOcclusion, IgnoresWhatClipPlanesCutAway) {
  scene::Snapshot s = occludedView({backWall(), test::parallelogram({0, 0, 50}, {500, 0, 0}, {0, 500, 0})});
  EXPECT_LT(meanOfHits(test::trace(s)), 0.1f);
  s.instances[1].clipPlanes = {{0, 0, -1, 20}};  // eye space: keeps z <= 20, and the lid is at 45
  EXPECT_EQ(meanOfHits(test::trace(s)), 1);
  s.instances[0].clipPlanes = s.instances[1].clipPlanes;
  EXPECT_EQ(meanOfHits(test::trace(s)), 1);
}

TEST(AmbientOcclusion, CulledSidesOccludeAsWell) {
  scene::Snapshot s =
      occludedView({backWall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})});
  for (const scene::CullFace cull : {scene::CullFace::front, scene::CullFace::back}) {
    s.instances[1].cull = cull;
    EXPECT_NEAR(meanOfHits(test::trace(s)), 0.5f, 0.004f);
  }
}

TEST(AmbientOcclusion, MayActOnAmbientLightAlone) {
  scene::Snapshot s =
      occludedView({backWall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})});
  s.settings.ao.on = AmbientOcclusionOn::ambient;
  EXPECT_EQ(meanOfHits(test::trace(s)), 1) << "colours without lighting have no ambient part";
  s.shadings[0].lighting = true;
  s.shadings[0].globalAmbient = {0.4f, 0.4f, 0.4f, 1};
  scene::Light light;
  light.ambient = {0.2f, 0.2f, 0.2f, 1};
  light.diffuse = {0.25f, 0.25f, 0.25f, 1};
  s.shadings[0].lights = {light};  // along the wall's normal
  for (scene::Instance& instance : s.instances) {
    instance.materials[0].front.ambient = instance.materials[0].front.diffuse = glm::vec4(1);
    instance.materials[0].back = instance.materials[0].front;
  }
  EXPECT_NEAR(meanOfHits(test::trace(s)), 0.5f * 0.6f + 0.25f, 0.004f);
  s.settings.ao.on = AmbientOcclusionOn::look;
  EXPECT_NEAR(meanOfHits(test::trace(s)), 0.5f * 0.85f, 0.004f);
}

TEST(AmbientOcclusion, ReachesAsFarAsItsDistance) {
  scene::Snapshot s = occludedView({backWall(), test::parallelogram({0, 0, 50}, {500, 0, 0}, {0, 500, 0})});
  s.settings.ao.distance = 49.5f;
  EXPECT_EQ(meanOfHits(test::trace(s)), 1);
  s.settings.ao.distance = 100;
  EXPECT_NEAR(meanOfHits(test::trace(s)), 0.25f, 0.004f);
}

TEST(AmbientOcclusion, TranslucentSurfacesHideAsMuchAsTheirAlpha) {
  for (const float alpha : {0.25f, 0.5f, 1.0f}) {
    scene::Snapshot s =
        occludedView({backWall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})});
    auto layers = std::make_shared<scene::Layers>();
    layers->opaqueDepth.assign(kOcclusionSize * kOcclusionSize, -1.0f);
    s.layers = layers;
    s.instances[1].color.a = alpha;
    EXPECT_NEAR(meanOfHits(test::trace(s)), 1 - 0.5f * alpha, 0.005f) << alpha;
  }
}

TEST(AmbientOcclusion, ConvexSurfacesDoNotDarkenThemselves) {
  for (const bool smooth : {false, true})
    for (const int around : {6, 10, 40, 400}) {
      scene::Snapshot s = occludedView({test::ballMesh(around, 1, {0, 0, 0}, smooth)});
      s.settings.ao.samples = 16;
      const test::Traced traced = test::trace(s);
      for (int y = 0; y < kOcclusionSize; ++y)
        for (int x = 0; x < kOcclusionSize; ++x)
          if (traced.hit(x, y)) {
            ASSERT_EQ(traced.color(x, y), glm::vec4(255)) << around << (smooth ? " smooth" : "");
          }
    }
}

/// The image of a corner, its world scaled by `scale` while eye space stays the same.
test::Traced corner(const glm::dvec3& scale) {
  const glm::dmat4 place = glm::scale(glm::dmat4(1), scale);
  const glm::vec3 inverse(1.0 / scale);
  const auto piece = [&](glm::vec3 c, glm::vec3 a, glm::vec3 b) {
    return test::parallelogram(c * inverse, a * inverse, b * inverse);
  };
  scene::Snapshot s =
      occludedView({piece({0, 0, 0}, {50, 0, 0}, {0, 50, 0}), piece({0.5f, 0, 1}, {0, 50, 0}, {0, 0, 1}),
                    piece({0, -0.5f, 0.5f}, {50, 0, 0}, {0, 0, 0.5f})});
  s.eyeFromWorld = s.eyeFromWorld * place;
  for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
  s.settings.ao.samples = 64;
  s.settings.ao.radius = 0.02f;
  return test::trace(s);
}

TEST(AmbientOcclusion, IsTheSameHoweverTheWorldIsScaled) {
  const test::Traced plain = corner({1, 1, 1});
  EXPECT_LT(meanOfHits(plain), 0.9f);
  for (const glm::dvec3& scale :
       {glm::dvec3(1, 1, 10), glm::dvec3(100, 1, 0.01), glm::dvec3(1e-6), glm::dvec3(1e6)}) {
    const test::Traced scaled = corner(scale);
    int beyond = 0;
    for (int y = 0; y < kOcclusionSize; ++y)
      for (int x = 0; x < kOcclusionSize; ++x)
        // Rays that graze an edge are decided by rounding: four of 64.
        beyond += test::difference(plain.color(x, y), scaled.color(x, y)) > 16 ? 1 : 0;
    // So is the surface that a pixel shows where two of them meet.
    EXPECT_LE(beyond, 2);
    EXPECT_NEAR(meanOfHits(plain), meanOfHits(scaled), 0.002f);
  }
}

TEST(AmbientOcclusion, OfScenesOfAnySize) {
  const auto imageOf = [](double size) {
    const auto sized = [&](glm::vec3 v) { return v * static_cast<float>(size); };
    scene::Snapshot s =
        occludedView({test::parallelogram({0, 0, 0}, sized({50, 0, 0}), sized({0, 50, 0})),
                      test::parallelogram(sized({0.5f, 0, 1}), sized({0, 50, 0}), sized({0, 0, 1}))});
    s.camera.clipFromEye = glm::perspective(glm::radians(40.0), 1.0, 0.1 * size, 1000.0 * size);
    s.eyeFromWorld = glm::translate(glm::dmat4(1), {0, 0, -5 * size});
    for (scene::Instance& instance : s.instances) instance.eyeFromObject = s.eyeFromWorld;
    s.settings.ao.radius = 0.02f;
    return test::trace(s);
  };
  const test::Traced plain = imageOf(1);
  EXPECT_LT(meanOfHits(plain), 0.95f);
  for (const double size : {1e-6, 1e-3, 1e3, 1e6})
    EXPECT_NEAR(meanOfHits(plain), meanOfHits(imageOf(size)), 0.002f) << size;
}

TEST(AmbientOcclusion, IsTheSameForAnyNumberOfThreadsAndNearlyForAnyInstructionSet) {
  scene::Snapshot s = occludedView({backWall(), test::parallelogram({1, 0, 1}, {0, 5, 0}, {0, 0, 1})});
  s.settings.ao.samples = 4;
  s.settings.ao.radius = 0.01f;
  const test::Traced one = test::trace(s);
  s.settings.threads = 4;
  const test::Traced four = test::trace(s);
  EXPECT_EQ(one.image.color, four.image.color);
  test::withEachTarget([&](int64_t) { EXPECT_NEAR(meanOfHits(test::trace(s)), meanOfHits(one), 0.002f); });
}

TEST(AmbientOcclusion, MultisampledAndAveragedImagesHaveIt) {
  scene::Snapshot s =
      occludedView({backWall(), test::parallelogram({3, 0, 5e4f}, {0, 5e5f, 0}, {0, 0, 5e4f})});
  s.samples = 4;
  s.samplePositions = {{0.375f, 0.125f}, {0.875f, 0.375f}, {0.125f, 0.625f}, {0.625f, 0.875f}};
  EXPECT_NEAR(meanOfHits(test::trace(s)), 0.5f, 0.004f);
  s.samples = 1, s.samplePositions.clear();
  s.settings.spp = 4, s.settings.ao.samples = 64;
  EXPECT_NEAR(meanOfHits(test::trace(s)), 0.5f, 0.004f);
}

}  // namespace
}  // namespace gluray::render
