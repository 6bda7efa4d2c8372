// Which pixels of a volume count as hits: what is blended, and what replaces the framebuffer's colours.
#include "render/testing/random_volumes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gluray::render {
namespace {

using scene::VolumeBlend;

/// A cube whose scalars are 0.25 on the left half of the picture and 0.75 on the right one.
scene::VolumeCast halves() {
  scene::VolumeCast cast;
  const test::VolumeBox box{.voxels = glm::ivec3(8)};
  const auto grid = test::makeGrid(scene::VoxelGrid::Type::single, box.voxels);
  test::eachVoxel(grid->size,
                  [&](const glm::ivec3& voxel) { test::store(*grid, voxel, voxel.x < 4 ? 0.25 : 0.75); });
  cast.volume.grid = grid;
  cast.volume.channels[0].opacity.values = {0, 0, 1, 1}, cast.volume.channels[0].color.values = {1, 1, 1};
  cast.volume.channels[0].color.channels = 3;
  const test::VolumeCamera camera{
      .eye = {0, 0, 4}, .up = {0, 1, 0}, .parallel = true, .height = 3, .pixels = {12, 12}};
  cast.view = viewOf(camera, box, 0.2);
  return cast;
}

struct Counts {
  long hits, visible;
};
Counts countsOf(const scene::VolumeCast& cast) {
  Arena arena(1);
  VolumeTracer tracer;
  Image image;
  const char* why = "";
  EXPECT_TRUE(tracer.trace(cast, arena, image, why)) << why;
  Counts counts{};
  for (size_t i = 0; i < image.depth.size(); ++i)
    counts.hits += image.depth[i] != Image::kMiss, counts.visible += image.wideColor[4 * i + 3] > 0;
  return counts;
}

TEST(ShownPixels, BlendedVolumesHaveTheVisibleOnes) {
  scene::VolumeCast cast = halves();
  for (const VolumeBlend blend : {VolumeBlend::composite, VolumeBlend::isosurface}) {
    cast.volume.blend = blend, cast.volume.contours = {0.9f};
    const Counts counts = countsOf(cast);
    EXPECT_EQ(counts.hits, counts.visible);
    EXPECT_EQ(counts.visible > 0, blend == VolumeBlend::composite);
  }
}

TEST(ShownPixels, ReplacingVolumesHaveAllOfTheBox) {
  scene::VolumeCast cast = halves();
  cast.view.replaces = true;
  constexpr long kBox = 8 * 8;  // two thirds of the picture
  for (const VolumeBlend blend : {VolumeBlend::composite, VolumeBlend::isosurface, VolumeBlend::maximum}) {
    cast.volume.blend = blend, cast.volume.contours = {0.9f};
    EXPECT_EQ(countsOf(cast).hits, kBox);
  }
  cast.volume.blend = VolumeBlend::composite;
  EXPECT_EQ(countsOf(cast).visible, kBox / 2);
  test::clip(cast.view, {{0, 1, 0, 0}});
  EXPECT_EQ(countsOf(cast).hits, kBox / 2) << "what is clipped is discarded";
}

}  // namespace
}  // namespace gluray::render
