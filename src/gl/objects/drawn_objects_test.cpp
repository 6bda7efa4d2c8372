// What contexts keep of the frames that they draw, for those who ask.
#include "gl/objects/drawn_objects.h"

#include <gtest/gtest.h>

#include <memory>

namespace gluray::gl {
namespace {

struct DrawnObjectsTest : testing::Test {
  DrawnObjectsTest() {
    shownFrames().wantUntil(nowSeconds() + 60);
    objects.checkAsked();
    key.framebuffer = 3;
  }
  ~DrawnObjectsTest() override { shownFrames().wantUntil(0); }
  /// Draws a batch of the context's frame of this number.
  scene::SnapshotPtr draw(uint64_t frame) {
    auto snapshot = std::make_shared<scene::Snapshot>();
    snapshot->frame = frame, snapshot->region = {0, 0, 8, 8};
    objects.number(key, *snapshot);
    objects.traced(key, snapshot);
    return snapshot;
  }
  static scene::SnapshotPtr lastShown() {
    const ShownFramePtr frame = shownFrames().last();
    return frame && !frame->batches.empty() ? frame->batches.back().snapshot : nullptr;
  }
  DrawnObjects objects;
  BatchKey key;
};

TEST_F(DrawnObjectsTest, WithoutSwapsEachBatchIsShown) {
  for (int i = 0; i < 2; ++i) {
    const scene::SnapshotPtr drawn = draw(1);
    EXPECT_EQ(lastShown(), drawn);
  }
  EXPECT_EQ(shownFrames().last()->batches.size(), 2u);
}

TEST_F(DrawnObjectsTest, OnceItsFramesAreShownOnlyThoseCount) {
  draw(1);
  objects.shown(1);
  const scene::SnapshotPtr shown = lastShown();
  draw(2);
  EXPECT_EQ(lastShown(), shown);
}

TEST_F(DrawnObjectsTest, OnceAnotherContextShowsThemEachBatchCountsAgain) {
  draw(1);
  objects.shown(1);
  objects.endFrame();
  const scene::SnapshotPtr drawn = draw(2);
  ShownFrame window;
  window.frame = 7;
  shownFrames().show(this, std::make_shared<const ShownFrame>(window));
  EXPECT_EQ(lastShown(), drawn);
}

TEST_F(DrawnObjectsTest, BatchesKnowWhichDepthsWereClearedBeforeThem) {
  objects.depthCleared(3, {0, 0, 8, 8});
  objects.depthCleared(4, {1, 1, 2, 2});
  draw(1);
  draw(1);
  const std::vector<ShownBatch>& batches = shownFrames().last()->batches;
  ASSERT_EQ(batches.size(), 2u);
  ASSERT_EQ(batches[0].cleared.size(), 2u);
  EXPECT_EQ(batches[0].cleared[1].framebuffer, 4u);
  EXPECT_EQ(batches[0].cleared[1].box, (scene::Region{1, 1, 2, 2}));
  EXPECT_TRUE(batches[1].cleared.empty());
}

}  // namespace
}  // namespace gluray::gl
