// What filters are told of pixels: known planes, the local look, reflectance.
#include "render/effects/feature_integrators.h"

#include "render/testing/test_trace.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace gluray::render {
namespace {

constexpr int kFeaturesSize = 48;
using Mode = scene::LightSampling::Mode;

/// Two parallel tilted squares side by side, the right one farther away along their normal by `apart`.
scene::Snapshot tilted(bool perspective, double apart) {
  const auto square = [](float x0, float x1, float z) {
    return test::makeMesh(test::quadData({x0, -2, z}, {x1, -2, z}, {x1, 2, z}, {x0, 2, z}));
  };
  scene::Snapshot s =
      test::makeSnapshot({square(-2, 0, 0), square(0, 2, static_cast<float>(-apart))}, kFeaturesSize);
  s.camera.clipFromEye = perspective ? glm::perspective(glm::radians(30.0), 1.0, 0.5, 20.0)
                                     : glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.5, 20.0);
  s.eyeFromWorld = glm::rotate(glm::translate(glm::dmat4(1), {0, 0, -4}), glm::radians(50.0), {0.3, 1, 0});
  for (scene::Instance& i : s.instances) i.eyeFromObject = s.eyeFromWorld * glm::dmat4(i.worldFromObject);
  s.settings.ao.enabled = true;
  s.wideColors = true;
  return s;
}

Image pass(scene::Snapshot s, Mode mode) {
  s.lightSampling.mode = mode;
  return test::trace(s).image;
}

/// How far pixel q is from the plane of pixel p, in widths of a pixel.
double offPlane(const Image& features, glm::ivec2 p, glm::ivec2 q) {
  const auto at = [&](glm::ivec2 i) {
    return features.wideColor.data() + 4 * static_cast<size_t>(i.y * features.width + i.x);
  };
  const float *a = at(p), *b = at(q);
  return double{a[0]} * (q.x - p.x) + double{a[1]} * (q.y - p.y) +
         double{a[2]} * (1 - double{a[3]} / double{b[3]});
}

TEST(GeometryFeatures, PixelsOfOnePlaneLieOnIt) {
  for (const bool perspective : {true, false}) {
    const Image features = pass(tilted(perspective, 0), Mode::geometry);
    for (const glm::ivec2 q : {glm::ivec2(5, 40), glm::ivec2(25, 24), glm::ivec2(36, 12)})
      EXPECT_NEAR(offPlane(features, {22, 22}, q), 0, 0.05) << perspective << ' ' << q.x;
  }
}

TEST(GeometryFeatures, OtherPlanesAreAsFarAwayAsTheyAre) {
  // In a parallel projection a pixel is 2 / kFeaturesSize wide everywhere.
  const double apart = 0.2;
  const Image features = pass(tilted(false, apart), Mode::geometry);
  EXPECT_NEAR(std::abs(offPlane(features, {10, 24}, {40, 24})), apart * kFeaturesSize / 2, 0.1);
  EXPECT_GT(std::abs(offPlane(pass(tilted(true, apart), Mode::geometry), {10, 24}, {40, 24})), 3);
}

TEST(GeometryFeatures, SeesEveryHit) {
  const Image features = pass(tilted(true, 0.2), Mode::geometry), look = pass(tilted(true, 0.2), Mode::full);
  EXPECT_EQ(features.depth, look.depth);
  for (size_t i = 0; i < features.depth.size(); ++i)
    EXPECT_EQ(features.depth[i] == Image::kMiss, !(features.wideColor[4 * i + 3] > 0)) << i;
}

TEST(ReflectanceFeature, IsTheLocalLookWhereLightIsAFactorOfIt) {
  scene::Snapshot s = tilted(true, 0.2);
  s.instances[0].color = {0.9f, 0.3f, 0.1f, 1};
  const Image features = pass(s, Mode::reflectance);
  s.settings.ao.enabled = false;
  EXPECT_EQ(features.wideColor, test::trace(s).image.wideColor);
}

TEST(ReflectanceFeature, IsTheSurfacesColourForPaths) {
  scene::Snapshot s = tilted(true, 0);
  s.settings.ao.enabled = false;
  s.settings.integrator = LightIntegrator::path;
  s.settings.exposure = 3;  // features have no tone
  s.shadings[0].lighting = true;
  for (scene::Instance& i : s.instances) {
    i.materials[0].front.diffuse = {0.5f, 0.25f, 0.125f, 1};
    i.materials[0].back = i.materials[0].front;
  }
  const test::Traced traced{pass(s, Mode::reflectance)};
  const float* const color = traced.image.wideColor.data() + 4 * traced.at(24, 24, 0);
  EXPECT_NEAR(color[0], 0.5f, 1e-5f);
  EXPECT_NEAR(color[1], 0.25f, 1e-5f);
  EXPECT_NEAR(color[2], 0.125f, 1e-5f);
}

/// Two walls in the light of several lights of the program, of which one throws a shadow to the other.
scene::Snapshot lightedWalls() {
  scene::Snapshot s = tilted(true, 1);
  s.settings.ao.enabled = false;
  s.settings.integrator = LightIntegrator::path;
  s.settings.path.samples = 1, s.settings.path.lights = 1, s.settings.path.clamp = 0;
  s.settings.environment.strength = 0;
  s.shadings[0].lighting = true;
  // Along the walls from the side of the nearer one, and from the viewer.
  const glm::vec4 beside(s.eyeFromWorld * glm::dvec4(-1, 0, 0.5, 0));
  for (const glm::vec4& position : {beside, glm::vec4(0, 0, 1, 0)}) {
    scene::Light light;
    light.position = position, light.diffuse = {0.4f, 0.5f, 0.3f, 1};
    s.shadings[0].lights.push_back(light);
  }
  for (scene::Instance& i : s.instances) {
    i.materials[0].front.diffuse = {0.5f, 0.25f, 0.125f, 1};
    i.materials[0].front.emission = {0.0f, 0.125f, 0.0f, 1};
    i.materials[0].back = i.materials[0].front;
  }
  return s;
}

TEST(NoiselessLight, IsThatOfLightsWithoutSizeAtTheFirstSurfaces) {
  scene::Snapshot s = lightedWalls();
  const Image noiseless = pass(s, Mode::noiseless);
  // All that is left of paths without bounces and sky; a mean over the choices of one light.
  s.settings.path.depth = 1, s.settings.path.samples = 4096;
  const Image mean = pass(s, Mode::full);
  double least = 1, most = 0;
  for (size_t i = 0; i < mean.wideColor.size(); ++i) {
    if (mean.depth[i / 4] == Image::kMiss || i % 4 == 3) continue;
    ASSERT_NEAR(noiseless.wideColor[i], mean.wideColor[i], 0.004) << i;
    if (i % 4 != 1) continue;
    least = std::min<double>(least, mean.wideColor[i]), most = std::max<double>(most, mean.wideColor[i]);
  }
  EXPECT_GT(most, least + 0.05) << "some of it is in the shadow";
}

TEST(NoiselessLight, IsOfNoSampleAndNotOfTheSky) {
  scene::Snapshot s = lightedWalls();
  const Image alone = pass(s, Mode::noiseless);
  s.settings.environment.strength = 1, s.settings.path.depth = 5, s.lightSampling.pass = 3;
  EXPECT_EQ(pass(s, Mode::noiseless).wideColor, alone.wideColor);
}

TEST(AuxiliaryFeatures, PassesTraceTheTilesThatTheyAreAskedFor) {
  scene::Snapshot s = tilted(true, 0);
  Arena arena{2};
  accel::World world;
  world.update(s, arena);
  Image image;
  traceImage(s, world, arena, image);
  const Image whole = image;
  std::fill(image.wideColor.begin(), image.wideColor.end(), -7.0f);
  s.lightSampling.tiles = std::make_shared<std::vector<uint8_t>>(std::vector<uint8_t>{0, 1, 1, 0});
  // Also where tiles are short because they may be interrupted.
  for (const bool interruptible : {false, true}) {
    TraceOptions options;
    if (interruptible) options.interrupt = [] { return false; };
    ASSERT_TRUE(traceImage(s, world, arena, image, options));
    for (int y = 0; y < kFeaturesSize; ++y)
      for (int x = 0; x < kFeaturesSize; ++x) {
        const size_t i = 4 * static_cast<size_t>(y * kFeaturesSize + x);
        EXPECT_EQ(image.wideColor[i], (x < 32) == (y < 32) ? -7.0f : whole.wideColor[i]) << x << ' ' << y;
      }
  }
}

TEST(SurfaceFeatures, NamesTheInstanceAndItsNormal) {
  for (const bool perspective : {true, false}) {
    const scene::Snapshot s = tilted(perspective, 0.2);
    const Image features = pass(s, Mode::surfaces);
    const glm::vec3 normal(glm::normalize(glm::dvec3(s.eyeFromWorld * glm::dvec4(0, 0, 1, 0))));
    for (const int x : {10, 40}) {
      const float* const at = features.wideColor.data() + 4 * static_cast<size_t>(24 * features.width + x);
      EXPECT_EQ(at[3], x < 24 ? 1 : 2);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(at[c], normal[c], 1e-5) << perspective << x << c;
      const Image points = pass(s, Mode::points);
      const float* const point = points.wideColor.data() + 4 * static_cast<size_t>(24 * points.width + x);
      const glm::dvec4 world = glm::inverse(s.eyeFromWorld) * glm::dvec4(point[0], point[1], point[2], 1);
      EXPECT_NEAR(world.z, x < 24 ? 0 : -0.2, 1e-5) << perspective;
      EXPECT_EQ(point[3], at[3]);
    }
  }
}

}  // namespace
}  // namespace gluray::render
