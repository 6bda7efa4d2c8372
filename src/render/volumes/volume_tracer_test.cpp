// Known answers of traced volumes; what is kept of them; which are refused.
#include "render/volumes/volume_tracer.h"

#include "accel/testing/test_grids.h"
#include "render/testing/test_volume_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace gluray::render {
namespace {

using scene::VolumeBlend;

/// A cube of side 2 that is seen along x, so that each ray has 20 samples. Voxel i along x has the value
/// value(i).
struct SeenCube {
  scene::VolumeCast cast;
  VolumeTracer tracer;
  static constexpr int kSamples = 20, kVoxels = 24;

  template <class Value>
  explicit SeenCube(const Value& value) {
    const test::VolumeBox box{.voxels = glm::ivec3(kVoxels)};
    cast.volume.grid = gridOf(value);
    cast.volume.channels[0].opacity.values = {1};
    cast.volume.channels[0].color.channels = 3, cast.volume.channels[0].color.values = {1, 1, 1};
    cast.volume.cellStep = glm::vec3(1.0f / kVoxels),
    cast.volume.cellSpacing = glm::vec3(2.0f / (kVoxels - 1));
    const test::VolumeCamera camera{.eye = {-4, 0, 0}, .parallel = true, .height = 1.5, .pixels = {9, 7}};
    cast.view = viewOf(camera, box, 2.0 / (kSamples + 0.5));
  }
  template <class Value>
  static std::shared_ptr<const scene::VoxelGrid> gridOf(const Value& value) {
    const auto grid = test::makeGrid(scene::VoxelGrid::Type::single, glm::ivec3(kVoxels));
    test::eachVoxel(grid->size, [&](const glm::ivec3& voxel) { test::store(*grid, voxel, value(voxel.x)); });
    return grid;
  }
  Image image() {
    Arena arena(1);
    Image made;
    const char* why = "";
    EXPECT_TRUE(tracer.trace(cast, arena, made, why)) << why;
    return made;
  }
  /// The colour of all pixels, which is the same.
  glm::vec4 color() {
    const Image made = image();
    const auto at = [&](size_t i) {
      return glm::vec4(made.wideColor[i], made.wideColor[i + 1], made.wideColor[i + 2],
                       made.wideColor[i + 3]);
    };
    for (size_t i = 4; i < made.wideColor.size(); i += 4)
      EXPECT_LT(glm::length(at(i) - at(0)), 1e-5f) << "pixel " << i / 4;
    return at(0);
  }
  std::string refusal() {
    Arena arena(1);
    Image made;
    const char* why = "";
    EXPECT_FALSE(tracer.trace(cast, arena, made, why));
    return why;
  }
};

void expectColor(const glm::vec4& found, const glm::dvec4& expected) {
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(double{found[c]}, expected[c], 2e-5) << "channel " << c;
}

/// A ramp from 0 to 1 along x.
double ramp(int x) { return static_cast<double>(x) / (SeenCube::kVoxels - 1); }
/// Its value at a sample.
double rampAt(int sample) { return (sample + 1) / (SeenCube::kSamples + 0.5); }
/// A table whose values are their coordinates, from 1/8 to 7/8.
std::vector<float> identity() { return {0.125f, 0.375f, 0.625f, 0.875f}; }

TEST(VolumeTracer, ConstantOpacityIsThatOfAllSteps) {
  for (const float opacity : {0.01f, 0.1f, 0.2f}) {
    SeenCube cube([](int) { return 0.5; });
    cube.cast.volume.channels[0].opacity.values = {opacity};
    cube.cast.volume.channels[0].color.values = {0.25f, 0.5f, 1};
    const double all = 1 - std::pow(1 - double{opacity}, SeenCube::kSamples);
    expectColor(cube.color(), {0.25 * all, 0.5 * all, all, all});
  }
}

TEST(VolumeTracer, RaysEndAboveTheirOpacity) {
  SeenCube cube([](int) { return 0.5; });
  cube.cast.volume.channels[0].opacity.values = {0.5f}, cube.cast.volume.least = 0.8f;
  expectColor(cube.color(), glm::dvec4(0.875));
  cube.cast.volume.least = 0.875f;
  expectColor(cube.color(), glm::dvec4(0.9375));
}

TEST(VolumeTracer, MaximumAndMinimumOfARamp) {
  for (const bool most : {true, false}) {
    SeenCube cube(ramp);
    cube.cast.volume.blend = most ? VolumeBlend::maximum : VolumeBlend::minimum;
    cube.cast.volume.channels[0].color.values = {0, 0, 0, 1, 1, 1},
    cube.cast.volume.channels[0].opacity.values = {0.5f};
    const double found = rampAt(most ? SeenCube::kSamples - 1 : 0);
    const double color = std::clamp(2 * found - 0.5, 0.0, 1.0) * 0.5;
    expectColor(cube.color(), {color, color, color, 0.5});
  }
}

TEST(VolumeTracer, SumsAndAveragesOfARamp) {
  double sum = 0, inRange = 0;
  int counted = 0;
  for (int i = 0; i < SeenCube::kSamples; ++i) {
    const double value = rampAt(i), product = 0.05 * value;
    sum += product;
    if (10 + 10 * value >= 12 && 10 + 10 * value <= 17) inRange += product, ++counted;
  }
  SeenCube cube(ramp);
  cube.cast.volume.channels[0].opacity.values = {0.05f}, cube.cast.volume.blend = VolumeBlend::additive;
  expectColor(cube.color(), {sum, sum, sum, 1});
  cube.cast.volume.blend = VolumeBlend::average, cube.cast.volume.averaged = {-100, 100};
  expectColor(cube.color(), {sum / 20, sum / 20, sum / 20, 1});
  cube.cast.volume.averaged = {12, 17}, cube.cast.volume.channels[0].range = {10, 20};
  expectColor(cube.color(), {inRange / counted, inRange / counted, inRange / counted, 1});
  cube.cast.volume.channels[0].color.values.clear();  // no colours are looked up
  expectColor(cube.color(), {inRange / counted, inRange / counted, inRange / counted, 1});
  cube.cast.volume.averaged = {30, 40};
  const Image nothing = cube.image();
  for (const float depth : nothing.depth) EXPECT_EQ(depth, Image::kMiss);
  for (const float value : nothing.wideColor) EXPECT_EQ(value, 0);
}

TEST(VolumeTracer, ScaleBiasAndFinishedColors) {
  SeenCube cube(ramp);
  cube.cast.volume.blend = VolumeBlend::maximum;
  cube.cast.volume.channels[0].scale = -2, cube.cast.volume.channels[0].bias = 0.8f;
  cube.cast.volume.channels[0].color.values.clear();
  for (const float v : identity())
    cube.cast.volume.channels[0].color.values.insert(cube.cast.volume.channels[0].color.values.end(), 3, v);
  cube.cast.volume.channels[0].opacity.values = {0.5f};
  cube.cast.volume.colorScale = 3, cube.cast.volume.colorBias = 0.1f;
  const double scalar = 0.8 - 2 * rampAt(0), shown = 3 * scalar * 0.5 + 0.1 * 0.5;
  expectColor(cube.color(), {shown, shown, shown, 0.5});
}

TEST(VolumeTracer, GradientsFaceTheViewerOrNot) {
  for (const bool towards : {true, false})
    for (const bool twoSided : {true, false}) {
      SeenCube cube([&](int x) { return towards ? ramp(x) : 1 - ramp(x); });
      scene::Volume& volume = cube.cast.volume;
      // A viewer that is far away: the light comes along x.
      cube.cast.view.viewer = {-1e7, 0, 0};
      scene::VolumeMaterial& material = test::addViewerLight(volume, twoSided);
      material.ambient = {0.1f, 0.2f, 0.3f}, material.diffuse = {0.5f, 0.4f, 0.3f};
      material.specular = {0.2f, 0.1f, 0}, material.shininess = 7;
      const bool lit = towards || twoSided;
      expectColor(cube.color(), {0.1 + (lit ? 0.7 : 0), 0.2 + (lit ? 0.5 : 0), 0.3 + (lit ? 0.3 : 0), 1});
    }
}

TEST(VolumeTracer, NoGradientNoLight) {
  SeenCube cube([](int) { return 0.3; });
  scene::Volume& volume = cube.cast.volume;
  scene::VolumeMaterial& material = test::addViewerLight(volume, true);
  material.ambient = glm::vec3(0.25f), material.diffuse = material.specular = glm::vec3(1);
  expectColor(cube.color(), {0.25, 0.25, 0.25, 1});
}

TEST(VolumeTracer, GradientOpacityOfARampAndOfNothing) {
  SeenCube cube(ramp);
  cube.cast.volume.channels[0].opacity.values = {0.2f};
  scene::VolumeTable table;
  table.values = identity();
  cube.cast.volume.channels[0].gradientOpacity = std::make_shared<scene::VolumeTable>(table);
  cube.cast.volume.channels[0].range = {0, 2};
  // Of the difference over two voxels.
  const double strength = 2.0 / (SeenCube::kVoxels - 1) * 2 / 2 / (0.25 * 2);
  const double all = 1 - std::pow(1 - 0.2 * strength, SeenCube::kSamples);
  EXPECT_NEAR(double{cube.color().a}, all, 5e-3) << "the last sample's difference is less";
  SeenCube even([](int) { return 0.3; });
  even.cast.volume.channels[0].gradientOpacity = cube.cast.volume.channels[0].gradientOpacity;
  EXPECT_NEAR(double{even.color().a}, 1 - std::pow(1 - 0.125, SeenCube::kSamples), 1e-5) << "the first entry";
}

TEST(VolumeTracer, ChangesAreSeen) {
  SeenCube cube([](int) { return 0.9; });
  cube.cast.volume.channels[0].opacity.values = {0.1f, 0};
  EXPECT_EQ(cube.color().a, 0);
  cube.cast.volume.channels[0].opacity.values = {0, 0.1f};
  const float visible = cube.color().a;
  EXPECT_GT(visible, 0.5f);
  cube.cast.volume.channels[0].bias = -0.9f;
  EXPECT_EQ(cube.color().a, 0);
  cube.cast.volume.channels[0].bias = 0, cube.cast.volume.channels[0].scale = 0.1f;
  EXPECT_EQ(cube.color().a, 0);
  cube.cast.volume.channels[0].scale = 1;
  EXPECT_EQ(cube.color().a, visible);
  cube.cast.volume.grid = SeenCube::gridOf([](int) { return 0.1; });
  EXPECT_EQ(cube.color().a, 0);
}

TEST(VolumeTracer, KeepsWhatItKnowsOfLivingGrids) {
  SeenCube cube(ramp);
  EXPECT_EQ(cube.tracer.bytes(), 0u);
  cube.color();
  const size_t one = cube.tracer.bytes();
  EXPECT_GT(one, 0u);
  cube.color();
  EXPECT_EQ(cube.tracer.bytes(), one);
  const auto first = cube.cast.volume.grid;
  cube.cast.volume.grid = SeenCube::gridOf(ramp);
  cube.color();
  EXPECT_EQ(cube.tracer.bytes(), 2 * one);
  cube.cast.volume.grid = first;
  cube.color();
  EXPECT_EQ(cube.tracer.bytes(), one) << "the second grid is gone";
}

TEST(VolumeTracer, RefusesWhatItCannotTrace) {
  SeenCube tables(ramp);
  tables.cast.volume.channels[0].opacity.values.clear();
  EXPECT_EQ(tables.refusal(), "it has no transfer function");
  tables.cast.volume.channels[0].opacity.values = {1}, tables.cast.volume.channels[0].color.values.clear();
  EXPECT_EQ(tables.refusal(), "it has no transfer function");
  SeenCube numbers([](int x) { return x == 3 ? std::numeric_limits<double>::quiet_NaN() : 0; });
  EXPECT_EQ(numbers.refusal(), "it has values that are no numbers");
  SeenCube large(ramp);
  auto grid = std::make_shared<scene::VoxelGrid>();
  grid->size = {2048, 2048, 513};
  large.cast.volume.grid = grid;
  EXPECT_EQ(large.refusal(), "it has more than 2^31 voxels");
}

TEST(VolumeTracer, SurvivesExtremeValues) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity(),
                  kNoNumber = std::numeric_limits<float>::quiet_NaN();
  for (const float extreme : {kInfinity, -kInfinity, kNoNumber, 3e38f, -3e38f, 1e-40f, 0.0f})
    for (const bool linear : {true, false})
      for (const VolumeBlend blend :
           {VolumeBlend::composite, VolumeBlend::maximum, VolumeBlend::average, VolumeBlend::isosurface}) {
        const auto change = [&](const auto& set) {
          SeenCube cube(ramp);
          cube.cast.volume.linear = linear, cube.cast.volume.blend = blend;
          cube.cast.volume.contours = {0.25f, 0.5f};
          cube.cast.volume.channels[0].opacity.values = {0, 0.1f, 0.3f};
          test::addViewerLight(cube.cast.volume).specular = glm::vec3(1);
          set(cube.cast.volume, cube.cast.view);
          cube.image();
        };
        change([&](scene::Volume& volume, auto&) { volume.channels[0].scale = extreme; });
        change([&](scene::Volume& volume, auto&) { volume.channels[0].bias = extreme; });
        change([&](scene::Volume& volume, auto&) { volume.channels[0].opacity.values[1] = extreme; });
        change([&](scene::Volume& volume, auto&) { volume.channels[0].color.values[1] = extreme; });
        change([&](scene::Volume& volume, auto&) { volume.cellStep = glm::vec3(extreme); });
        change([&](scene::Volume& volume, auto&) { volume.channels[0].material.shininess = extreme; });
        change([&](scene::Volume& volume, auto&) {
          volume.channels[0].range = volume.averaged = glm::vec2(extreme);
        });
        change([&](auto&, scene::VolumeView& view) { view.textureFromData[3][1] = double{extreme}; });
        change([&](auto&, scene::VolumeView& view) { view.viewer.y = double{extreme}; });
        change([&](auto&, scene::VolumeView& view) { view.depth.assign(9 * 7, extreme); });
      }
}

TEST(VolumeTracer, PixelsDoNotDependOnTheirNeighbours) {
  for (const VolumeBlend blend : {VolumeBlend::composite, VolumeBlend::maximum, VolumeBlend::minimum,
                                  VolumeBlend::average, VolumeBlend::additive}) {
    SeenCube cube([](int x) { return 0.5 + 0.4 * std::sin(x); });
    scene::Volume& volume = cube.cast.volume;
    volume.blend = blend, volume.channels[0].opacity.values = {0, 0, 0.1f, 0.2f},
    volume.averaged = {0.2f, 0.8f};
    scene::VolumeMaterial& material = test::addViewerLight(volume);
    material.diffuse = material.specular = glm::vec3(0.5f);
    const test::VolumeBox box{.voxels = glm::ivec3(SeenCube::kVoxels)};
    cube.cast.view = viewOf({.eye = {-2, 3, 4}, .height = 0.8, .pixels = {37, 21}}, box, 0.07);
    const Image all = cube.image();
    for (const scene::Region region : {scene::Region{13, 9, 1, 1}, {18, 4, 11, 13}, {20, 12, 2, 1}}) {
      cube.cast.view.region = region;
      const Image part = cube.image();
      for (int y = 0; y < region.height; ++y)
        for (int x = 0; x < region.width; ++x) {
          const auto a = static_cast<size_t>(y * region.width + x),
                     b = static_cast<size_t>((region.y + y) * all.width + region.x + x);
          EXPECT_EQ(part.depth[a], all.depth[b]);
          for (size_t c = 0; c < 4; ++c)
            EXPECT_EQ(part.wideColor[4 * a + c], all.wideColor[4 * b + c]) << x << " " << y;
        }
    }
  }
}

}  // namespace
}  // namespace gluray::render
