// Traced volumes equal a plain loop over all samples, with every instruction set.
#include "accel/testing/test_grids.h"
#include "render/testing/reference_volume.h"
#include "render/testing/test_targets.h"
#include "render/testing/test_volume_view.h"
#include "render/volumes/volume_tracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace gluray::render {
namespace {

using scene::VolumeBlend;

constexpr double kTolerance = 1e-4;  // colours of 0 to 1: rounding of floats

scene::VolumeTable randomTable(test::Random& random, int channels, bool linear) {
  scene::VolumeTable table;
  table.channels = channels, table.linear = linear;
  const int entries = random.integer(1, 24), zeros = random.integer(0, entries / 2);
  for (int i = 0; i < entries; ++i)
    for (int c = 0; c < channels; ++c) {
      const double value = random.real();
      table.values.push_back(channels == 1 && i < zeros ? 0.0f : static_cast<float>(value));
    }
  return table;
}

/// A random volume whose scalars lie in and somewhat around 0 .. 1.
scene::Volume randomVolume(test::Random& random, scene::VoxelGrid::Type type, const test::VolumeBox& box) {
  scene::Volume volume;
  const auto grid = test::makeGrid(type, box.voxels);
  test::fillRandomly(*grid, random, -0.2, 1.2);
  // Empty space beside it.
  const glm::ivec3 end = grid->size / 2;
  if (random.integer(0, 1) == 1)
    test::eachVoxel(end, [&](const glm::ivec3& voxel) { test::store(*grid, voxel, 0); });
  volume.grid = grid;
  const bool inverted = random.integer(0, 3) == 0;
  volume.scale = inverted ? -1 : 1, volume.bias = inverted ? 1 : 0;
  volume.opacity = randomTable(random, 1, true);
  // More steps with less opacity reach the voxels behind.
  const double dim = random.real(0.05, 0.6);
  for (float& a : volume.opacity.values) a *= static_cast<float>(dim);
  volume.color = randomTable(random, 3, true);
  volume.cellStep = 1.0f / glm::vec3(box.voxels);
  volume.cellSpacing = glm::vec3(box.upper - box.lower) / glm::vec3(glm::max(box.voxels - 1, 1));
  volume.range = {random.real(-3, 0), random.real(1, 5)};
  volume.averaged = {-10, 10};
  return volume;
}

void addLight(test::Random& random, scene::Volume& volume) {
  volume.light.enabled = true, volume.light.twoSided = random.integer(0, 1) == 1;
  volume.light.ambient = random.point(0, 0.3), volume.light.diffuse = random.point(0.2, 0.9);
  volume.light.specular = random.point(0, 0.5),
  volume.light.shininess = static_cast<float>(random.real(1, 20));
}

struct RandomCast {
  test::VolumeBox box;
  scene::VolumeCast cast;
};

/// A random view of a random volume.
RandomCast randomCast(test::Random& random, scene::VoxelGrid::Type type, int most) {
  RandomCast made;
  made.box.voxels = random.size(1, most);
  made.box.lower = random.point(-1.2, -0.4), made.box.upper = random.point(0.4, 1.2);
  made.cast.volume = randomVolume(random, type, made.box);
  test::VolumeCamera camera;
  const bool inside = random.integer(0, 5) == 0;
  camera.pixels = {random.integer(1, 30), random.integer(1, 20)};
  camera.eye = inside ? random.point(-0.3, 0.3) : glm::normalize(random.point(-1, 1)) * random.real(3, 8);
  camera.target = inside ? camera.eye + random.point(-1, 1) : random.point(-0.3, 0.3);
  if (inside) camera.near = 0.02;
  camera.parallel = !inside && random.integer(0, 1) == 1;
  camera.height = camera.parallel ? 2.5 : 0.7;
  made.cast.view = viewOf(camera, made.box, random.real(0.03, 0.2), inside);
  return made;
}

/// Depths of what stands in the volume.
void addDepths(test::Random& random, scene::VolumeView& view) {
  for (int p = 0; p < view.region.width * view.region.height; ++p) {
    const glm::dvec4 window = view.windowFromData * glm::dvec4(random.point(-1.5, 1.5), 1);
    const bool open = random.integer(0, 2) == 0;
    view.depth.push_back(open ? 1.0f : static_cast<float>(std::clamp(window.z / window.w, 0.0, 1.0)));
  }
}

using ReferencePixels = std::vector<test::ReferencePixel>;

ReferencePixels referenceOf(const RandomCast& made) {
  ReferencePixels pixels;
  test::ReferenceVolume reference(made.cast, made.box);
  for (int y = 0; y < made.cast.view.region.height; ++y)
    for (int x = 0; x < made.cast.view.region.width; ++x) pixels.push_back(reference.at(x, y));
  return pixels;
}

/// Compares a traced image with the reference.
void expectReference(const RandomCast& made, const ReferencePixels& reference, Arena& arena) {
  VolumeTracer tracer;
  Image image;
  const char* why = "";
  ASSERT_TRUE(tracer.trace(made.cast, arena, image, why)) << why;
  ASSERT_EQ(image.depth.size(), reference.size());
  for (size_t i = 0; i < reference.size(); ++i) {
    const test::ReferencePixel& expected = reference[i];
    if (expected.unsure) continue;
    const size_t x = i % static_cast<size_t>(image.width), y = i / static_cast<size_t>(image.width);
    EXPECT_EQ(image.depth[i] != Image::kMiss, expected.shown) << x << " " << y;
    EXPECT_NEAR(double{image.depth[i]}, expected.depth, 1e-6) << x << " " << y;
    for (int c = 0; c < 4; ++c)
      EXPECT_NEAR(double{image.wideColor[4 * i + static_cast<size_t>(c)]}, expected.color[c], kTolerance)
          << "pixel " << x << " " << y << ", channel " << c;
  }
}

/// How many of all pixels show something, and how many cannot be compared.
struct Seen {
  size_t pixels = 0, shown = 0, unsure = 0;
  void add(const ReferencePixels& reference) {
    for (const test::ReferencePixel& pixel : reference)
      ++pixels, shown += pixel.shown, unsure += pixel.unsure;
  }
};

/// Calls change(random, cast) on random casts of all types of voxels and compares each with the reference.
template <class Change>
void expectReferences(unsigned seed, double mostUnsure, const Change& change, int voxels = 40) {
  constexpr int kRounds = 30;
  Arena arena(2);
  test::Random random(seed);
  Seen seen;
  for (int round = 0; round < kRounds; ++round)
    for (const scene::VoxelGrid::Type type : test::kVoxelTypes) {
      RandomCast made = randomCast(random, type, voxels);
      change(random, made.cast);
      const ReferencePixels reference = referenceOf(made);
      seen.add(reference);
      test::withEachTarget([&](int64_t target) {
        const glm::ivec3& size = made.box.voxels;
        SCOPED_TRACE(testing::Message()
                     << "round " << round << ", type " << static_cast<int>(type) << ", voxels " << size.x
                     << " " << size.y << " " << size.z << ", target " << target);
        expectReference(made, reference, arena);
      });
      if (testing::Test::HasFailure()) return;
    }
  EXPECT_GT(seen.shown, seen.pixels / 4);
  EXPECT_LE(static_cast<double>(seen.unsure), mostUnsure * static_cast<double>(seen.pixels));
}

void setBlend(test::Random& random, scene::Volume& volume) {
  constexpr VolumeBlend kBlends[] = {VolumeBlend::composite, VolumeBlend::maximum, VolumeBlend::minimum,
                                     VolumeBlend::average, VolumeBlend::additive};
  volume.blend = kBlends[random.integer(0, 4)];
}

TEST(VolumeReference, CompositesAsAPlainLoop) {
  expectReferences(1, 0.02, [](test::Random&, scene::VolumeCast&) {});
}

TEST(VolumeReference, LightsAsAPlainLoop) {
  expectReferences(2, 0.1,
                   [](test::Random& random, scene::VolumeCast& cast) { addLight(random, cast.volume); });
}

TEST(VolumeReference, WeighsByGradientsAsAPlainLoop) {
  expectReferences(3, 0.1, [](test::Random& random, scene::VolumeCast& cast) {
    cast.volume.gradientOpacity = std::make_shared<scene::VolumeTable>(randomTable(random, 1, true));
    if (random.integer(0, 1) == 1) addLight(random, cast.volume);
  });
}

TEST(VolumeReference, EndsAtDepthsAsAPlainLoop) {
  expectReferences(4, 0.1, [](test::Random& random, scene::VolumeCast& cast) {
    setBlend(random, cast.volume), addDepths(random, cast.view);
  });
}

TEST(VolumeReference, BlendsAsAPlainLoop) {
  expectReferences(5, 0.1, [](test::Random& random, scene::VolumeCast& cast) {
    setBlend(random, cast.volume);
    cast.volume.averaged = {random.real(-3, 0), random.real(0.5, 3)};
    cast.volume.colorScale = static_cast<float>(random.real(0.5, 1.5));
    cast.volume.colorBias = static_cast<float>(random.real(-0.2, 0.2));
  });
}

TEST(VolumeReference, LightsExtremesAsAPlainLoop) {
  expectReferences(6, 0.1, [](test::Random& random, scene::VolumeCast& cast) {
    cast.volume.blend = random.integer(0, 1) == 1 ? VolumeBlend::maximum : VolumeBlend::minimum;
    addLight(random, cast.volume);
    if (random.integer(0, 1) == 1)
      cast.volume.gradientOpacity = std::make_shared<scene::VolumeTable>(randomTable(random, 1, true));
  });
}

TEST(VolumeReference, TakesNearestValuesAsAPlainLoop) {
  expectReferences(
      7, 0.2,
      [](test::Random& random, scene::VolumeCast& cast) {
        setBlend(random, cast.volume);
        cast.volume.linear = random.integer(0, 2) == 0;
        cast.volume.opacity.linear = random.integer(0, 1) == 1;
        cast.volume.color.linear = random.integer(0, 1) == 1;
      },
      12);
}

}  // namespace
}  // namespace gluray::render
