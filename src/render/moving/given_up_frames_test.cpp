// Frames of animations that are given up.
#include "render/moving/moving_tile_source.h"
#include "render/testing/test_animation.h"
#include "render/tiles/tile.h"

#include <gtest/gtest.h>

#include <atomic>

namespace gluray::render {
namespace {

/// Gives a frame up when all its tiles have been collected.
class GivesUp final : public MovingTileSource {
 public:
  void begin(const Image& image) noexcept override {
    const Tiles tiles(image, kTileSize);
    left_ = tiles.columns * tiles.rows;
  }
  int nextTile() noexcept override { return --left_; }
  void done(int, double, bool) noexcept override { ADD_FAILURE() << "no tile is coloured"; }
  uint32_t index(uint32_t own) const noexcept override { return own; }
  void collected(const VisibilityBuffer&, int, double) noexcept override { ++tiles; }
  bool complete(VisibilityBuffer&) noexcept override { return false; }
  int nextToColor() noexcept override { return -1; }

  std::atomic<int> tiles{0};

 private:
  std::atomic<int> left_{0};
};

TEST(GivenUpFrames, LeaveTheHistory) {
  test::Animation one, other;
  scene::Snapshot s = test::boards();
  s.lightSampling.mode = test::Mode::moving;
  for (int i = 0; i < 4; ++i) {
    test::turn(s, i);
    if (i == 2) {
      GivesUp source;
      Image image;
      TraceOptions options;
      options.histories = &other.histories, options.source = &source, options.movingSource = &source;
      other.world.update(s, other.arena);
      traceImage(s, other.world, other.arena, image, options);
      EXPECT_EQ(source.tiles, 9);
    }
    EXPECT_EQ(one.frame(s).image.color, other.frame(s).image.color) << i;
  }
}

}  // namespace
}  // namespace gluray::render
