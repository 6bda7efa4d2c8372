// The secondary scenes of batches, and that nothing is kept without need.
#include "gl/views/view_scenes.h"

#include <gtest/gtest.h>

#include <memory>

namespace gluray::gl {
namespace {

scene::Instance surfaceOf(uint64_t geometry, double x = 0) {
  auto mesh = std::make_shared<scene::Mesh>();
  mesh->geometryId = {geometry, 0};
  mesh->triangleCount = 1;
  scene::Instance instance;
  instance.mesh = mesh;
  instance.eyeFromObject[3][0] = x;
  instance.materials.resize(1);
  return instance;
}

BatchKey keyOf(GLuint framebuffer = 0) {
  BatchKey key;
  key.framebuffer = framebuffer;
  key.viewport = {0, 0, 100, 100};
  key.region = {0, 0, 100, 100};
  return key;
}

TEST(ViewFramesTest, BeginWithWhatIsTracedAfterClears) {
  ViewFrames frames;
  const scene::Region view{0, 0, 10, 10};
  EXPECT_EQ(frames.traced(1, view), 1u);
  EXPECT_EQ(frames.traced(1, view), 1u) << "another batch";
  for (int i = 0; i < 3; ++i) frames.cleared(1, {0, 0, 20, 20});
  EXPECT_EQ(frames.traced(1, view), 2u) << "however often it is cleared";
  frames.cleared(1, {5, 5, 20, 20});
  frames.cleared(2, {0, 0, 20, 20});
  EXPECT_EQ(frames.traced(1, view), 2u) << "neither a part nor another framebuffer";
  for (int i = 0; i < 200; ++i) {
    frames.traced(3, {i, 0, 10, 10});
    frames.cleared(1, view);
    EXPECT_EQ(frames.traced(1, view), static_cast<uint64_t>(3 + i)) << "those in use are remembered";
  }
}

class ViewScenesTest : public testing::Test {
 protected:
  std::shared_ptr<scene::Snapshot> snapshotOf(std::vector<scene::Instance> instances) const {
    auto s = std::make_shared<scene::Snapshot>();
    s->settings.ao.enabled = lit_;
    s->region = {0, 0, 100, 100};
    s->eyeFromWorld = instances.front().eyeFromObject;
    s->shadings.resize(1);
    s->instances = std::move(instances);
    return s;
  }
  /// Geometries around the batch that is traced next.
  std::vector<uint64_t> trace(const BatchKey& key, std::vector<scene::Instance> instances) {
    return trace(key, snapshotOf(std::move(instances)));
  }
  std::vector<uint64_t> trace(const BatchKey& key, const std::shared_ptr<scene::Snapshot>& s) {
    s->secondaryScene = views_.secondaryScene(key, *s);
    views_.traced(key, s);
    last_ = s;
    std::vector<uint64_t> found;
    if (s->secondaryScene)
      for (const scene::Instance& i : s->secondaryScene->instances) found.push_back(i.mesh->geometryId.low);
    return found;
  }
  void clear(GLuint framebuffer = 0) { views_.depthCleared(framebuffer, {0, 0, 1000, 1000}); }
  using Found = std::vector<uint64_t>;

  ViewScenes views_;
  scene::SnapshotPtr last_;
  bool lit_ = true;
};

TEST_F(ViewScenesTest, EarlierBatchesSurround) {
  EXPECT_EQ(trace(keyOf(), {surfaceOf(1)}), Found{});
  EXPECT_EQ(trace(keyOf(), {surfaceOf(2), surfaceOf(3)}), Found{1});
  EXPECT_EQ(trace(keyOf(), {surfaceOf(4)}), (Found{1, 2, 3}));
}

TEST_F(ViewScenesTest, EachSurfaceSurroundsOnce) {
  trace(keyOf(), {surfaceOf(1), surfaceOf(2)});
  EXPECT_EQ(trace(keyOf(), {surfaceOf(2), surfaceOf(1, 5)}), Found{1}) << "it draws the second itself";
  EXPECT_EQ(trace(keyOf(), {surfaceOf(3)}), (Found{1, 2, 1}));
}

TEST_F(ViewScenesTest, SecondaryScenesLieInTheWorldOfTheBatch) {
  trace(keyOf(), {surfaceOf(1, 2)});
  trace(keyOf(), {surfaceOf(2, 5)});
  const scene::SecondaryScene& around = *last_->secondaryScene;
  EXPECT_EQ(around.instances[0].worldFromObject[3].x, -3);
  EXPECT_EQ(around.instances[0].eyeFromObject[3].x, 2);
  EXPECT_EQ(around.viewFromWorld[3].x, 3);
  trace(keyOf(), {surfaceOf(3, 2)});
  EXPECT_EQ(last_->secondaryScene->instances[0].worldFromObject, glm::mat4(1));
  EXPECT_EQ(last_->secondaryScene->viewFromWorld, glm::dmat4(1));
}

TEST_F(ViewScenesTest, ShadingsAndBlendingComeAlong) {
  auto blended = snapshotOf({surfaceOf(1)});
  blended->layers = std::make_shared<scene::Layers>();
  blended->shadings[0].twoSided = true;
  trace(keyOf(), blended);
  auto other = snapshotOf({surfaceOf(2)});
  trace(keyOf(), other);
  trace(keyOf(), {surfaceOf(3)});
  const scene::SecondaryScene& around = *last_->secondaryScene;
  ASSERT_EQ(around.instances.size(), 2u);
  EXPECT_TRUE(around.shadings[around.instances[0].shading].twoSided);
  EXPECT_FALSE(around.shadings[around.instances[1].shading].twoSided);
  EXPECT_TRUE(around.blended[0]);
  EXPECT_FALSE(around.blended[1]);
  EXPECT_TRUE(scene::isBlended(*last_, 1));
  EXPECT_FALSE(scene::isBlended(*last_, 0));
}

/// Images come along with the matrices of the draws, in later frames, too, although their surfaces have
/// moved.
TEST_F(ViewScenesTest, ImagesComeAlong) {
  const auto capture = std::make_shared<const scene::FramebufferCapture>();
  glm::dmat4 clipFromObject(1);
  for (int frame = 0; frame < 2; ++frame) {
    trace(keyOf(), {surfaceOf(1, frame)});
    if (frame == 0) {
      auto drawn = snapshotOf({surfaceOf(2), surfaceOf(3, 4)});
      clipFromObject = drawn->instances[1].eyeFromObject;
      views_.traced(keyOf(), drawn, capture);
      trace(keyOf(), {surfaceOf(4)});
    }
    const scene::SecondaryScene& around = *last_->secondaryScene;
    const size_t first = frame == 0 ? 1 : 0;  // of the captured ones
    ASSERT_EQ(around.captures.size(), 1u);
    EXPECT_EQ(around.captures[0], capture);
    ASSERT_EQ(around.captured.size(), first + 2);
    if (first) { EXPECT_EQ(around.captured[0].capture, scene::CapturedSurface::kNone); }
    EXPECT_EQ(around.captured[first + 1].capture, 0u);
    EXPECT_EQ(around.captured[first + 1].clipFromObject, clipFromObject);
    EXPECT_EQ(around.instances[first + 1].eyeFromObject[3].x, 4 + frame);
    clear();
  }
}

TEST_F(ViewScenesTest, LaterBatchesComeFromTheFrameBefore) {
  for (int frame = 0; frame < 3; ++frame) {
    const bool known = frame > 0;
    EXPECT_EQ(trace(keyOf(), {surfaceOf(1)}), known ? (Found{2, 3}) : Found{});
    EXPECT_EQ(trace(keyOf(), {surfaceOf(2)}), known ? (Found{1, 3}) : Found{1});
    EXPECT_EQ(trace(keyOf(), {surfaceOf(3)}), (Found{1, 2}));
    frame % 2 ? clear() : views_.swapped();
  }
}

TEST_F(ViewScenesTest, GeometryThatChangesInEveryFrameIsFoundByItsTurn) {
  for (uint64_t frame = 0; frame < 3; ++frame) {
    const uint64_t before = frame - 1;
    EXPECT_EQ(trace(keyOf(), {surfaceOf(100 + frame)}), frame ? (Found{200 + before, 7}) : Found{});
    EXPECT_EQ(trace(keyOf(), {surfaceOf(200 + frame)}), frame ? (Found{100 + frame, 7}) : Found{100 + frame});
    trace(keyOf(), {surfaceOf(7)});
    clear();
  }
}

TEST_F(ViewScenesTest, WhatIsLeftOutIsNotWaitedFor) {
  for (int frame = 0; frame < 2; ++frame) {
    for (const uint64_t geometry : {1, 2, 3}) trace(keyOf(), {surfaceOf(geometry)});
    clear();
  }
  EXPECT_EQ(trace(keyOf(), {surfaceOf(1)}), (Found{2, 3}));
  EXPECT_EQ(trace(keyOf(), {surfaceOf(3)}), Found{1}) << "the second is not drawn in this frame";
}

TEST_F(ViewScenesTest, ASurfaceOfSeveralPassesIsNotYetToCome) {
  for (int frame = 0; frame < 2; ++frame) {
    EXPECT_EQ(trace(keyOf(), {surfaceOf(1)}), frame ? Found{2} : Found{});
    trace(keyOf(), {surfaceOf(2)});
    EXPECT_EQ(trace(keyOf(), {surfaceOf(1)}), Found{2});
    clear();
  }
}

TEST_F(ViewScenesTest, ViewsStayApart) {
  trace(keyOf(), {surfaceOf(1)});
  BatchKey elsewhere = keyOf(), right = keyOf();
  elsewhere.viewport = {100, 0, 100, 100};
  right.drawBuffer = GL_BACK_RIGHT;
  EXPECT_EQ(trace(keyOf(5), {surfaceOf(2)}), Found{});
  EXPECT_EQ(trace(elsewhere, {surfaceOf(2)}), Found{});
  EXPECT_EQ(trace(right, {surfaceOf(2)}), Found{});
  auto zoomed = snapshotOf({surfaceOf(2)});
  zoomed->camera.clipFromEye[0][0] = 2;
  EXPECT_EQ(trace(keyOf(), zoomed), Found{});
  EXPECT_EQ(trace(keyOf(), {surfaceOf(3)}), Found{1});
  clear(5);
  EXPECT_EQ(trace(keyOf(5), {surfaceOf(4)}), Found{});
  EXPECT_EQ(trace(keyOf(), {surfaceOf(5)}), (Found{1, 3}));
}

TEST_F(ViewScenesTest, AClearBesideTheSurfacesEndsNothing) {
  auto small = snapshotOf({surfaceOf(1)});
  small->region = {10, 10, 20, 20};
  trace(keyOf(), small);
  views_.depthCleared(0, {15, 15, 100, 100});
  EXPECT_EQ(trace(keyOf(), {surfaceOf(2)}), Found{1});
  views_.depthCleared(0, {0, 0, 100, 100});
  EXPECT_EQ(trace(keyOf(), {surfaceOf(3), surfaceOf(4)}), Found{});
}

TEST_F(ViewScenesTest, PassesOfLayersBelongToTheViewOfTheirSizeAndCamera) {
  BatchKey peeled = keyOf(9), large = keyOf(9);
  peeled.layers = large.layers = BatchKey::Layers::peeled;
  large.viewport = {0, 0, 200, 100};
  const auto layersOf = [&](uint64_t geometry) {
    auto s = snapshotOf({surfaceOf(geometry)});
    s->layers = std::make_shared<scene::Layers>();
    return s;
  };
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_EQ(trace(keyOf(), {surfaceOf(1)}), frame ? Found{2} : Found{});
    EXPECT_EQ(trace(peeled, layersOf(2)), Found{1});
    EXPECT_EQ(trace(large, layersOf(3)), Found{});
    clear();
  }
  EXPECT_EQ(trace(peeled, layersOf(2)), Found{}) << "without opaque surfaces nothing tells when it ends";
  EXPECT_EQ(trace(peeled, layersOf(4)), Found{});
}

TEST_F(ViewScenesTest, PeeledLayersThatTheRealOpenGLDrawsLightNothing) {
  BatchKey peeled = keyOf(9);
  peeled.layers = BatchKey::Layers::peeled;
  auto layers = snapshotOf({surfaceOf(2)});
  layers->layers = std::make_shared<scene::Layers>();
  trace(keyOf(), {surfaceOf(1)});
  trace(peeled, layers);
  views_.withdrawPeeled(1);
  EXPECT_EQ(trace(keyOf(), {surfaceOf(3)}), (Found{1, 2})) << "of another frame";
  views_.withdrawPeeled(0);
  EXPECT_EQ(trace(keyOf(), {surfaceOf(4)}), (Found{1, 3}));
  clear();
  EXPECT_EQ(trace(keyOf(), {surfaceOf(1)}), (Found{3, 4}));
}

TEST_F(ViewScenesTest, NothingIsKeptWhileNoSettingAsksForLight) {
  lit_ = false;
  std::weak_ptr<const scene::Mesh> mesh;
  {
    const scene::Instance instance = surfaceOf(1);
    mesh = instance.mesh;
    trace(keyOf(), {instance});
  }
  last_.reset();
  EXPECT_TRUE(views_.empty());
  EXPECT_TRUE(mesh.expired());
}

TEST_F(ViewScenesTest, SwitchingOffLetsGo) {
  std::weak_ptr<const scene::Mesh> mesh;
  {
    const scene::Instance instance = surfaceOf(1);
    mesh = instance.mesh;
    trace(keyOf(), {instance});
    trace(keyOf(), {surfaceOf(2)});
    clear();
  }
  last_.reset();
  EXPECT_FALSE(mesh.expired()) << "the next frame may need it";
  lit_ = false;
  trace(keyOf(), {surfaceOf(3)});
  EXPECT_TRUE(mesh.expired());
}

TEST_F(ViewScenesTest, MeshesLiveTwoFramesLonger) {
  std::vector<std::weak_ptr<const scene::Mesh>> meshes;
  for (uint64_t frame = 0; frame < 8; ++frame) {
    for (uint64_t k = 0; k < 2; ++k) {
      const scene::Instance instance = surfaceOf(10 * frame + k);
      meshes.push_back(instance.mesh);
      trace(keyOf(), {instance});
    }
    clear();
  }
  for (size_t i = 0; i + 4 < meshes.size(); ++i) EXPECT_TRUE(meshes[i].expired()) << i;
}

TEST_F(ViewScenesTest, AnEpochThatNothingEndsIsBounded) {
  for (uint64_t i = 0; i < 1000; ++i) trace(keyOf(3), {surfaceOf(i)});
  EXPECT_LE(last_->secondaryScene->instances.size(), 256u);
}

}  // namespace
}  // namespace gluray::gl
