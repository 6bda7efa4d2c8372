// Extents of scenes of which a program draws only what is in view.
#include "gl/views/scene_extents.h"

#include <gtest/gtest.h>

#include <memory>

namespace gluray::gl {
namespace {

/// A unit cube; `x`: its place along the x axis of the scene. The camera sees x from -10 to 10 around
/// `camera`.
scene::Instance cubeAt(uint64_t geometry, double x, double camera) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->geometryId = {geometry, 0};
  mesh->lower = glm::vec3(-0.5f), mesh->upper = glm::vec3(0.5f);
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject[3] = glm::dvec4(x - camera, 0, 0, 1);
  return instance;
}

scene::SnapshotPtr snapshotOf(double camera, const std::vector<std::pair<uint64_t, double>>& cubes) {
  auto snapshot = std::make_shared<scene::Snapshot>();
  snapshot->camera.clipFromEye = glm::dmat4(0.1);
  snapshot->camera.clipFromEye[3][3] = 1;
  for (const auto& [geometry, x] : cubes) snapshot->instances.push_back(cubeAt(geometry, x, camera));
  snapshot->eyeFromWorld = snapshot->instances.front().eyeFromObject;
  return snapshot;
}

void remember(SceneExtents& extents, const scene::SnapshotPtr& snapshot) {
  ViewEpoch epoch;
  epoch.batches.push_back({snapshot, false, nullptr, nullptr});
  extents.remember(epoch);
}

float lengthOf(double x) { return static_cast<float>(glm::length(glm::dvec3(x, 1, 1))); }

TEST(SceneExtents, WhatIsOutOfViewCounts) {
  SceneExtents extents;
  EXPECT_EQ(extents.extentOf(*snapshotOf(0, {{1, 0}, {2, 5}})), 0) << "nothing is known";
  remember(extents, snapshotOf(0, {{1, 0}, {2, 5}}));
  EXPECT_EQ(extents.extentOf(*snapshotOf(0, {{1, 0}, {2, 5}})), 0) << "all is drawn";
  EXPECT_FLOAT_EQ(extents.extentOf(*snapshotOf(-8, {{1, 0}})), lengthOf(6)) << "the camera has moved";
  EXPECT_FLOAT_EQ(extents.extentOf(*snapshotOf(13, {{2, 5}})), lengthOf(6)) << "to the other side";
}

TEST(SceneExtents, WhatTheCameraWouldSeeIsHidden) {
  SceneExtents extents;
  remember(extents, snapshotOf(0, {{1, 0}, {2, 5}}));
  EXPECT_EQ(extents.extentOf(*snapshotOf(0, {{1, 0}})), 0);
  remember(extents, snapshotOf(0, {{1, 0}}));
  EXPECT_EQ(extents.extentOf(*snapshotOf(-8, {{1, 0}})), 0) << "and forgotten";
}

TEST(SceneExtents, AProgramThatDrawsWhatIsOutOfViewLeavesNothingOut) {
  SceneExtents extents;
  for (uint64_t frame = 0; frame < 8; ++frame) {
    const auto now = snapshotOf(0, {{1, 0}, {100 + frame, 30 + static_cast<double>(frame)}});
    EXPECT_EQ(extents.extentOf(*now), 0) << "the second one changes in each frame";
    remember(extents, now);
  }
}

TEST(SceneExtents, GrowsFromTileToTile) {
  SceneExtents extents;
  remember(extents, snapshotOf(0, {{1, 0}, {2, 5}}));
  remember(extents, snapshotOf(15, {{2, 5}, {3, 20}}));
  remember(extents, snapshotOf(30, {{3, 20}, {4, 35}}));
  EXPECT_FLOAT_EQ(extents.extentOf(*snapshotOf(30, {{3, 20}, {4, 35}})), lengthOf(36));
  EXPECT_FLOAT_EQ(extents.extentOf(*snapshotOf(-8, {{1, 0}})), lengthOf(36));
}

TEST(SceneExtents, OtherScenesAreApart) {
  SceneExtents extents;
  remember(extents, snapshotOf(0, {{1, 0}, {2, 5}}));
  EXPECT_EQ(extents.extentOf(*snapshotOf(-8, {{7, 0}})), 0);
  for (uint64_t other = 10; other < 14; ++other) remember(extents, snapshotOf(0, {{other, 0}}));
  EXPECT_EQ(extents.extentOf(*snapshotOf(-8, {{1, 0}})), 0) << "forgotten after four others";
}

}  // namespace
}  // namespace gluray::gl
