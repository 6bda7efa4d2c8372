#include "gl/framebuffers/composed_pixels.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using Pixels = std::vector<uint32_t>;
constexpr uint32_t kBlue = 0xffff0000, kRed = 0xff0000ff, kHalfRed = 0x80000080;  // premultiplied

TEST(ComposedPixels, ImageOverWhatWasThere) {
  EXPECT_TRUE(isComposed({kBlue, kBlue, 7}, {kRed, 0, 0}, 0, {kRed, kBlue, 7}));
}

TEST(ComposedPixels, EdgesAreBlendedOrCutByBoxes) {
  EXPECT_TRUE(isComposed({kBlue, kBlue}, {kRed, kHalfRed}, 0, {kRed, 0xff7f0080}));
  EXPECT_TRUE(isComposed({kBlue, kBlue}, {kRed, kHalfRed}, 0, {kRed, 0xff800080})) << "another rounding";
  EXPECT_TRUE(isComposed({kBlue, kBlue}, {kRed, kHalfRed}, 0, {kRed, kBlue})) << "outside of all boxes";
  EXPECT_FALSE(isComposed({kBlue, kBlue}, {kRed, kHalfRed}, 0, {kRed, 0xff810080}));
}

TEST(ComposedPixels, NoSurfaceMayBeMissing) {
  EXPECT_FALSE(isComposed({kBlue, kBlue}, {kRed, kRed}, 0, {kRed, kBlue}));
}

TEST(ComposedPixels, NothingElseMayBeDrawn) {
  EXPECT_FALSE(isComposed({kBlue, kBlue}, {kRed, 0}, 0, {kRed, kRed}));
  EXPECT_FALSE(isComposed({kBlue, kBlue}, {kRed, 0}, 0, {kRed + 1, kBlue})) << "exact where nothing blends";
}

TEST(ComposedPixels, SomethingIsDrawn) {
  EXPECT_FALSE(isComposed({kBlue, kBlue}, {0, 0}, 0, {kBlue, kBlue}));
  EXPECT_FALSE(isComposed({kRed, kBlue}, {kRed, 0}, 0, {kRed, kBlue})) << "it was there before";
  EXPECT_FALSE(isComposed({kBlue}, {kRed, 0}, 0, {kRed}));
}

/// Ranks may clear to an opaque colour, which may be composed with the surfaces.
TEST(ComposedPixels, OpaqueBackgrounds) {
  EXPECT_TRUE(isComposed({kBlue, kBlue}, {kRed, 0xff000000}, 0xff000000, {kRed, 0xff000000}));
  EXPECT_TRUE(isComposed({kBlue, kBlue}, {kRed, 0xff000000}, 0xff000000, {kRed, kBlue}));
}

}  // namespace
}  // namespace gluray::gl
