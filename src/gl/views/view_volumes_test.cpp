// Volumes in secondary scenes, as media that block light.
#include "gl/views/view_scenes.h"
#include "scene/secondary_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace gluray::gl {
namespace {

std::shared_ptr<scene::Snapshot> sheetOf(uint64_t geometry, double x = 0) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->geometryId = {geometry, 1};
  mesh->triangleCount = 1;
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject[3][0] = x;
  instance.materials.resize(1);
  auto s = std::make_shared<scene::Snapshot>();
  s->settings.ao.enabled = true;
  s->region = {0, 0, 100, 100};
  s->eyeFromWorld = instance.eyeFromObject;
  s->shadings.resize(1);
  s->instances = {std::move(instance)};
  return s;
}

/// A volume's part of a view, with voxels of its own.
std::shared_ptr<scene::Snapshot> volumeOf(const std::shared_ptr<const scene::VoxelGrid>& grid, double x = 0) {
  auto medium = std::make_shared<scene::Medium>();
  medium->volume.grid = grid;
  auto s = std::make_shared<scene::Snapshot>();
  s->settings.ao.enabled = true;
  s->region = {0, 0, 100, 100};
  s->eyeFromWorld[3][0] = x;
  s->volumes = {{medium, s->eyeFromWorld}};
  return s;
}

class ViewVolumes : public testing::Test {
 protected:
  void trace(const std::shared_ptr<scene::Snapshot>& s) {
    BatchKey key;
    key.viewport = {0, 0, 100, 100}, key.region = {0, 0, 100, 100};
    s->secondaryScene = views_.secondaryScene(key, *s);
    views_.traced(key, s);
    last_ = s;
  }
  size_t volumesAround() const { return last_->secondaryScene ? last_->secondaryScene->volumes.size() : 0; }
  void clear() { views_.depthCleared(0, {0, 0, 1000, 1000}); }

  ViewScenes views_;
  scene::SnapshotPtr last_;
};

TEST_F(ViewVolumes, SurroundAndAreSurrounded) {
  const auto grid = std::make_shared<const scene::VoxelGrid>();
  trace(sheetOf(1));
  trace(volumeOf(grid, 3));
  EXPECT_EQ(last_->secondaryScene->instances.size(), 1u);
  EXPECT_EQ(volumesAround(), 0u) << "a volume does not surround itself";
  trace(sheetOf(2));
  ASSERT_EQ(volumesAround(), 1u);
  EXPECT_EQ(last_->secondaryScene->volumes[0].eyeFromData[3].x, 3);
  clear();
  trace(sheetOf(1, 1));
  ASSERT_EQ(volumesAround(), 1u) << "it is taken for granted";
  EXPECT_EQ(last_->secondaryScene->volumes[0].eyeFromData[3].x, 4) << "where it would be if the camera moved";
}

TEST_F(ViewVolumes, OfEarlierFramesAreNotHeld) {
  std::weak_ptr<const scene::VoxelGrid> grids[4];
  for (auto& held : grids) {
    const auto grid = std::make_shared<const scene::VoxelGrid>();
    held = grid;
    trace(sheetOf(1));
    trace(volumeOf(grid));
    last_.reset();
    clear();
  }
  EXPECT_TRUE(grids[0].expired());
  EXPECT_TRUE(grids[1].expired()) << "the last frame was lit with the one before it";
  EXPECT_FALSE(grids[3].expired()) << "the last one may come again";
}

TEST_F(ViewVolumes, ThatWereClearedAwaySurroundNothing) {
  auto volume = volumeOf(std::make_shared<const scene::VoxelGrid>());
  volume->region = {10, 10, 20, 20};
  trace(sheetOf(1));
  trace(volume);
  views_.depthCleared(0, {5, 5, 50, 50});
  trace(sheetOf(2));
  EXPECT_TRUE(last_->secondaryScene->volumes.empty());
}

}  // namespace
}  // namespace gluray::gl
