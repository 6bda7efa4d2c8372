#include "cluster/worker/picture.h"

#include "cluster/stream/tile_pixels.h"
#include "render/tiles/tiles.h"

#include <gtest/gtest.h>

namespace gluray::cluster {
namespace {

constexpr int kSize = 4 * render::kTileSize;

/// A picture of two ranks, of which the first one traces all that it gets and the other one nothing.
class PictureOfASlowRank : public testing::Test {
 protected:
  void trace(Picture& picture, double now) {
    Image image;
    image.resize(kSize, kSize, 1);
    for (std::vector<int> tiles; !(tiles = picture.more(0)).empty();)
      for (const int tile : tiles) {
        TracedTile traced;
        traced.shape = shapeOf(image), traced.tile = tile;
        traced.pixels = packTile(image, render::Tiles(kSize, kSize, render::kTileSize).at(tile));
        bool grew = false;
        picture.addTile(0, traced, memory_, grew, now);
      }
  }
  Picture started(Picture::Kind kind) {
    TraceRequest request;
    request.width = request.height = kSize;
    Picture picture(request, 1, false, RankStates(2, 0, 1), {}, kind, 0);
    EXPECT_FALSE(picture.more(1).empty());
    trace(picture, 0.1);
    EXPECT_FALSE(picture.isTraced());
    return picture;
  }
  WrittenMemory memory_;
};

TEST_F(PictureOfASlowRank, PassesItsTilesOn) {
  Picture picture = started(Picture::Kind::shared);
  EXPECT_TRUE(picture.passOnSlow(0.4).empty());
  EXPECT_EQ(picture.passOnSlow(0.6), std::vector{1});
  trace(picture, 0.6);
  EXPECT_TRUE(picture.isTraced());
}

TEST_F(PictureOfASlowRank, LeavesItTimeToFetchPages) {
  Picture picture = started(Picture::Kind::paged);
  EXPECT_TRUE(picture.passOnSlow(4.9).empty());
  EXPECT_EQ(picture.passOnSlow(5.1), std::vector{1});
  trace(picture, 5.1);
  EXPECT_TRUE(picture.isTraced());
}

}  // namespace
}  // namespace gluray::cluster
