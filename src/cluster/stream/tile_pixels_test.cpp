// Tiles of images travel without loss; tiles without surfaces are one colour.
#include "cluster/stream/tile_pixels.h"

#include <gtest/gtest.h>

#include <numeric>

namespace gluray::cluster {
namespace {

constexpr render::Tile kRight{32, 0, 60, 20};

Image imageOf(Planes planes, int samples = 1) {
  Image image;
  image.resize(60, 20, samples, planes);
  std::iota(image.color.begin(), image.color.end(), 7u);
  std::iota(image.wideColor.begin(), image.wideColor.end(), 0.5f);
  std::iota(image.depth.begin(), image.depth.end(), 0.25f);
  std::iota(image.centerDepth.begin(), image.centerDepth.end(), 0.125f);
  return image;
}

Image emptyImage() {
  Image image = imageOf(Image::kColorDepth);
  image.missColor = 0x80102030;
  std::fill(image.color.begin(), image.color.end(), image.missColor);
  std::fill(image.depth.begin(), image.depth.end(), Image::kMiss);
  return image;
}

/// The tile in an image of zeros.
Image carried(const Image& image, const std::vector<std::byte>& bytes) {
  Image to;
  to.resize(image.width, image.height, image.samples, image.planes);
  unpackTile(bytes, shapeOf(image), planesOf(to), kRight);
  return to;
}

void expectSame(const Image& image) {
  const Image to = carried(image, packTile(image, kRight));
  for (int sample = 0; sample < image.samples; ++sample) {
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const auto at = static_cast<size_t>((sample * image.height + y) * image.width + x);
        const bool inside = x >= kRight.x0;
        EXPECT_EQ(to.depth[at], inside ? image.depth[at] : 0.0f);
        if (!image.color.empty()) { EXPECT_EQ(to.color[at], inside ? image.color[at] : 0u); }
        if (!image.wideColor.empty()) {
          EXPECT_EQ(to.wideColor[4 * at + 3], inside ? image.wideColor[4 * at + 3] : 0.0f);
        }
      }
    }
  }
}

TEST(TilePixels, AreTheSame) {
  expectSame(imageOf(Image::kColorDepth));
  expectSame(imageOf(Image::kWide));
  expectSame(imageOf(Image::kColorDepth, 4));
  expectSame(imageOf(Image::kColorDepth | Plane::centerDepth));
}

TEST(TilePixels, WithoutSurfacesAreOneColor) {
  const Image empty = emptyImage();
  EXPECT_EQ(packTile(empty, kRight).size(), sizeof(uint32_t));
  expectSame(empty);
}

TEST(TilePixels, OneHitIsEnough) {
  Image image = emptyImage();
  image.depth[5 * 60 + 40] = 0.5f;
  EXPECT_EQ(packTile(image, kRight).size(), 8u * 28 * 20);
  expectSame(image);
  Image colored = emptyImage();
  colored.color[5 * 60 + 40] = 1;
  expectSame(colored);
}

TEST(TilePixels, OfAnotherSizeAreRefused) {
  const Image image = imageOf(Image::kWide);
  EXPECT_THROW(carried(image, std::vector<std::byte>(4)), Malformed) << "only bytes have a colour of misses";
  EXPECT_THROW(carried(emptyImage(), std::vector<std::byte>(5)), Malformed);
  EXPECT_THROW(carried(emptyImage(), {}), Malformed);
}

}  // namespace
}  // namespace gluray::cluster
