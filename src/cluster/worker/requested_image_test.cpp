#include "cluster/worker/requested_image.h"

#include "cluster/stream/tile_pixels.h"
#include "render/tiles/tiles.h"

#include <gtest/gtest.h>

namespace gluray::cluster {
namespace {

constexpr int kSize = 4 * render::kTileSize;

/// An image of two ranks, of which the first one traces all that it gets and the other one nothing.
class ImageOfASlowRank : public testing::Test {
 protected:
  void trace(RequestedImage& requested, double now) {
    Image image;
    image.resize(kSize, kSize, 1);
    for (std::vector<int> tiles; !(tiles = requested.more(0)).empty();)
      for (const int tile : tiles) {
        TracedTile traced;
        traced.shape = shapeOf(image), traced.tile = tile;
        traced.pixels = packTile(image, render::Tiles(kSize, kSize, render::kTileSize).at(tile));
        bool grew = false;
        requested.addTile(0, traced, memory_, grew, now);
      }
  }
  RequestedImage started(RequestedImage::Kind kind) {
    TraceRequest request;
    request.width = request.height = kSize;
    RequestedImage requested(request, 1, false, RankStates(2, 0, 1), {}, kind, 0);
    EXPECT_FALSE(requested.more(1).empty());
    trace(requested, 0.1);
    EXPECT_FALSE(requested.isTraced());
    return requested;
  }
  WrittenMemory memory_;
};

TEST_F(ImageOfASlowRank, PassesItsTilesOn) {
  RequestedImage requested = started(RequestedImage::Kind::shared);
  EXPECT_TRUE(requested.passOnSlow(0.4).empty());
  EXPECT_EQ(requested.passOnSlow(0.6), std::vector{1});
  trace(requested, 0.6);
  EXPECT_TRUE(requested.isTraced());
}

TEST_F(ImageOfASlowRank, LeavesItTimeToFetchPages) {
  RequestedImage requested = started(RequestedImage::Kind::paged);
  EXPECT_TRUE(requested.passOnSlow(4.9).empty());
  EXPECT_EQ(requested.passOnSlow(5.1), std::vector{1});
  trace(requested, 5.1);
  EXPECT_TRUE(requested.isTraced());
}

}  // namespace
}  // namespace gluray::cluster
