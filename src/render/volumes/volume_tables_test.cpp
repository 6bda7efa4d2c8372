// Traced volumes with tables of two coordinates: equal a plain loop over all samples, with every instruction
// set; changes.
#include "render/testing/random_volumes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace gluray::render {
namespace {

using namespace test;

/// A table of which some columns, rows or entries are invisible. Colours and opacities may exceed 1.
std::shared_ptr<scene::VolumeTable2D> randomTable2D(Random& random) {
  auto table = std::make_shared<scene::VolumeTable2D>();
  table->size = {random.integer(1, 16), random.integer(1, 9)};
  table->linear = random.integer(0, 3) > 0;
  const int columns = random.integer(0, table->size.x / 2), rows = random.integer(0, table->size.y / 2);
  const float least = random.integer(0, 3) == 0 ? -0.1f : 0.0f;
  const double most = random.integer(0, 3) == 0 ? 1.4 : random.real(0.1, 0.6);
  for (int y = 0; y < table->size.y; ++y)
    for (int x = 0; x < table->size.x; ++x) {
      const glm::vec3 color = random.point(0, 1.3);
      const double opacity = random.real(0, most);
      const bool invisible = x < columns || y < rows || random.integer(0, 4) == 0;
      table->values.emplace_back(color, invisible ? least : static_cast<float>(opacity));
    }
  return table;
}

void setTable(Random& random, scene::Volume& volume) {
  volume.use = scene::VolumeChannels::table;
  volume.table = randomTable2D(random);
  volume.channels[0].opacity = volume.channels[0].color = {};
}

TEST(VolumeReference, LooksUpScalarsAndGradientsAsAPlainLoop) {
  expectReferences(13, 0.15, [](Random& random, RandomCast& made) { setTable(random, made.cast.volume); });
}

TEST(VolumeReference, LightsTablesAsAPlainLoop) {
  expectReferences(14, 0.3, [](Random& random, RandomCast& made) {
    scene::Volume& volume = made.cast.volume;
    setTable(random, volume);
    if (random.integer(0, 1) == 1)
      addLight(random, volume);
    else
      addLights(random, volume);
  });
}

TEST(VolumeReference, LooksUpNearestVoxelsInTablesAsAPlainLoop) {
  expectReferences(
      15, 0.35,
      [](Random& random, RandomCast& made) {
        setTable(random, made.cast.volume);
        made.cast.volume.linear = false;
        if (random.integer(0, 1) == 1) addDepths(random, made.cast.view);
      },
      12);
}

void setLabels(Random& random, scene::Volume& volume) {
  volume.use = scene::VolumeChannels::labels;
  auto table = randomTable2D(random);
  for (glm::vec4& entry : table->values) entry.a = std::max(entry.a, 0.0f);
  volume.table = table;
  const auto voxels = makeGrid(scene::VoxelGrid::Type::byte, random.size(1, 9));
  eachVoxel(voxels->size,
            [&](const glm::ivec3& voxel) { store(*voxels, voxel, random.integer(0, 4) / 255.0); });
  volume.labels.voxels = voxels;
  volume.labels.share = random.integer(0, 1) == 1 ? 1.0f : static_cast<float>(random.real(0.1, 0.9));
  volume.labels.rows = {0, 0.3f, 0.55f, 1, -0.5f};
}

TEST(VolumeReference, LabelsSamplesAsAPlainLoop) {
  expectReferences(16, 0.4, [](Random& random, RandomCast& made) { setLabels(random, made.cast.volume); });
}

TEST(VolumeReference, LightsLabelsAsAPlainLoop) {
  expectReferences(17, 0.45, [](Random& random, RandomCast& made) {
    scene::Volume& volume = made.cast.volume;
    setLabels(random, volume);
    if (random.integer(0, 2) > 0)
      addLight(random, volume);
    else if (random.integer(0, 1) == 1)
      addLights(random, volume);
    if (random.integer(0, 1) == 1)
      volume.channels[0].gradientOpacity = std::make_shared<scene::VolumeTable>(randomTable(random, 1, true));
  });
}

/// A cube of one scalar, whose rays have about 20 samples.
scene::VolumeCast evenCube() {
  scene::VolumeCast cast;
  const VolumeBox box{.voxels = glm::ivec3(24)};
  const auto grid = makeGrid(scene::VoxelGrid::Type::single, box.voxels);
  eachVoxel(grid->size, [&](const glm::ivec3& voxel) { store(*grid, voxel, 0.5); });
  cast.volume.grid = grid, cast.volume.use = scene::VolumeChannels::table;
  cast.volume.cellStep = glm::vec3(1.0f / 24), cast.volume.cellSpacing = glm::vec3(2.0f / 23);
  cast.view = viewOf({.eye = {-4, 0, 0}, .parallel = true, .height = 1.5, .pixels = {9, 7}}, box, 0.1);
  return cast;
}

TEST(VolumeTracer, SeesChangedTables) {
  Arena arena(1);
  VolumeTracer tracer;
  scene::VolumeCast cast = evenCube();
  const char* why = "";
  const auto colorWith = [&](float opacity) {
    auto table = std::make_shared<scene::VolumeTable2D>();
    table->size = {4, 2}, table->values.assign(8, {1, 0.5f, 2, opacity});
    cast.volume.table = table;
    Image image;
    EXPECT_TRUE(tracer.trace(cast, arena, image, why)) << why;
    return glm::vec4(image.wideColor[0], image.wideColor[1], image.wideColor[2], image.wideColor[3]);
  };
  EXPECT_EQ(colorWith(0).a, 0);
  const glm::vec4 seen = colorWith(0.2f);
  EXPECT_GT(seen.a, 0.2f);
  EXPECT_FLOAT_EQ(seen.r, seen.a);
  EXPECT_FLOAT_EQ(seen.g, seen.a / 2);
  EXPECT_FLOAT_EQ(seen.b, seen.a * 2) << "colours are not limited to 1";
  EXPECT_EQ(colorWith(0).a, 0);
  Image image;
  cast.volume.table = nullptr;
  EXPECT_FALSE(tracer.trace(cast, arena, image, why));
  EXPECT_STREQ(why, "it has no transfer function");
}

}  // namespace
}  // namespace gluray::render
