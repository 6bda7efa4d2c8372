// Volumes with one map for colours and opacities equal a plain loop over all samples, with every instruction
// set.
#include "render/testing/random_volumes.h"
#include "render/testing/reference_levels.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gluray::render {
namespace {

using namespace test;
using scene::VolumeBlend;

/// A view of the box from -0.5 to size - 0.5, all faces of it, around the viewer or in front.
scene::VolumeView spanView(Random& random, const glm::ivec3& voxels, bool inside) {
  VolumeCamera camera;
  const glm::dvec3 size(voxels), middle = size * 0.5 - 0.5;
  const double length = glm::length(size);
  camera.pixels = {random.integer(4, 30), random.integer(4, 20)};
  camera.eye = middle + (inside ? 0.2 * size * random.point(-1, 1)
                                : glm::normalize(random.point(-1, 1)) * length * random.real(0.8, 2));
  camera.target = inside ? camera.eye + random.point(-1, 1) : middle;
  camera.parallel = !inside && random.integer(0, 1) == 1;
  camera.height = camera.parallel ? length : 0.8;
  camera.near = 0.5, camera.far = 5 * length;
  scene::VolumeView view;
  view.region = {0, 0, camera.pixels.x, camera.pixels.y};
  view.windowFromData = windowFromData(camera);
  const VolumeBox box{glm::dvec3(-0.5), size - 0.5, voxels};
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true})
      for (const glm::dvec3& corner : boxFace(box, axis, upper)) view.faces.push_back(corner);
  scene::VolumeSpan& span = view.span.emplace();
  span.size = size, span.step = random.real(0.3, 1.5), span.shift = random.integer(0, 1) == 1 ? 0.5 : 0;
  // The point of the same pixel at window depth 0 and 1: z becomes 0 and w.
  glm::dmat4 near(1), far(1);
  near[2][2] = 0, far[2][2] = 0, far[3][2] = 1;
  for (auto& [to, depth] : {std::pair(&span.nearFromData, near), std::pair(&span.farFromData, far)})
    *to = glm::inverse(view.windowFromData) * depth * view.windowFromData;
  // In window depths, from 0 to 1: as clip coordinates, from -1 to 1.
  glm::dmat4 clip(1);
  clip[2][2] = 2, clip[3][2] = -1;
  span.depthFromData = clip * view.windowFromData, span.showsDepth = random.integer(0, 2) > 0;
  return view;
}

/// A map of few entries: steep ones enlarge the rounding of scalars.
scene::VolumeTable randomMap(Random& random) {
  scene::VolumeTable map;
  map.channels = 4, map.linear = random.integer(0, 3) > 0;
  for (int i = 4 * random.integer(1, 5); i > 0; --i) map.values.push_back(static_cast<float>(random.real()));
  return map;
}

scene::VolumeCast levelCast(Random& random, scene::VoxelGrid::Type type, VolumeBlend blend) {
  scene::VolumeCast cast;
  VolumeBox box{.voxels = random.size(2, 24)};
  cast.volume = randomVolume(random, type, box);
  cast.volume.blend = blend, cast.volume.channels[0].opacity.values.clear();
  cast.volume.channels[0].color = randomMap(random);
  cast.volume.linear = random.integer(0, 3) > 0;
  cast.volume.cellStep = 1.5f / glm::vec3(box.voxels);
  scene::VolumeLevels& levels = cast.volume.levels;
  levels.limits = {random.real(-0.2, 0.3), random.real(0.6, 1.3)};
  if (random.integer(0, 3) == 0) std::swap(levels.limits.x, levels.limits.y);
  if (random.integer(0, 1) == 1) levels.gamma = static_cast<float>(random.real(0.4, 2));
  if (random.integer(0, 2) == 0) levels.leastMaximum = static_cast<float>(random.real(0.5, 1));
  if (random.integer(0, 2) == 0) levels.mostMinimum = static_cast<float>(random.real(0, 0.5));
  levels.attenuation = static_cast<float>(random.real(0, 1.5));
  levels.attenuationStep = static_cast<float>(random.real(0.05, 0.8));
  levels.threshold = static_cast<float>(random.real(0.2, 0.9));
  if (random.integer(0, 1) == 1) levels.opacity = static_cast<float>(random.real());
  for (int i = random.integer(0, 4) - 2; i > 0; --i) {
    const glm::dvec3 normal = random.point(-1, 1);
    levels.planes.emplace_back(normal, -glm::dot(normal, random.point(0.3, 0.7)));
  }
  cast.view = spanView(random, box.voxels, random.integer(0, 3) == 0);
  const glm::dvec2 pixels(cast.view.region.width, cast.view.region.height);
  if (random.integer(0, 3) == 0) cast.view.span->window = {1, 0.7 * pixels.x, 0.2 * pixels.y, pixels.y};
  return cast;
}

/// `mostUnsure`: share of pixels that cannot be compared.
void expectLevels(VolumeBlend blend, double mostUnsure) {
  constexpr int kRounds = 25;
  constexpr double kDepths = 2e-5;  // of texture coordinates as floats, near the viewer
  Arena arena(2);
  Random random(static_cast<unsigned>(blend) + 100);
  Seen seen;
  for (int round = 0; round < kRounds; ++round)
    for (const scene::VoxelGrid::Type type : kVoxelTypes) {
      const RandomCast made{{}, levelCast(random, type, blend)};
      ReferencePixels pixels;
      ReferenceLevels reference(made.cast);
      for (int y = 0; y < made.cast.view.region.height; ++y)
        for (int x = 0; x < made.cast.view.region.width; ++x) pixels.push_back(reference.at(x, y));
      seen.add(pixels);
      withEachTarget([&](int64_t target) {
        SCOPED_TRACE(::testing::Message()
                     << "round " << round << ", type " << static_cast<int>(type) << ", target " << target);
        expectReference(made, pixels, arena, kDepths);
      });
      if (::testing::Test::HasFailure()) return;
    }
  EXPECT_GT(seen.shown, seen.pixels / 8);
  EXPECT_LE(static_cast<double>(seen.unsure), mostUnsure * static_cast<double>(seen.pixels));
}

TEST(VolumeLevels, RefinedMaximum) { expectLevels(VolumeBlend::refinedMaximum, 0.2); }
TEST(VolumeLevels, RefinedMinimum) { expectLevels(VolumeBlend::refinedMinimum, 0.2); }
TEST(VolumeLevels, AttenuatedMaximum) { expectLevels(VolumeBlend::attenuatedMaximum, 0.2); }
TEST(VolumeLevels, Over) { expectLevels(VolumeBlend::over, 0.2); }
TEST(VolumeLevels, Screened) { expectLevels(VolumeBlend::screened, 0.2); }
TEST(VolumeLevels, Mean) { expectLevels(VolumeBlend::mean, 0.2); }
TEST(VolumeLevels, Surface) { expectLevels(VolumeBlend::surface, 0.2); }

}  // namespace
}  // namespace gluray::render
