// What a window shows beside traced surfaces: told from noise, rounding and filters.
#include "saved/shot/plate.h"

#include <gtest/gtest.h>

namespace gluray::saved {
namespace {

constexpr int kWide = 12, kHigh = 9;
constexpr uint32_t kSky = 0xff806040, kSurface = 0xff2040e0, kText = 0xffffffff;

/// A surface in columns 4 to 7.
bool isSurface(int x) { return x >= 4 && x < 8; }
size_t at(int x, int y) { return static_cast<size_t>(y * kWide + x); }

struct PlateTest : testing::Test {
  SavedPicture shown{kWide, kHigh, {}};
  std::vector<uint32_t> traced;
  PlateTest() {
    for (int y = 0; y < kHigh; ++y)
      for (int x = 0; x < kWide; ++x) {
        shown.pixels.push_back(isSurface(x) ? kSurface : kSky);
        traced.push_back(isSurface(x) ? kSurface : 0);
      }
  }
  static glm::dvec2 middle(int x, int y) { return {x + 0.5, y + 0.5}; }
};

TEST_F(PlateTest, HasNoOverlayWhereTheWindowShowsTheSurface) {
  const Plate plate(shown, traced, true);
  EXPECT_FALSE(plate.hasOverlays());
  for (int x = 0; x < kWide; ++x) EXPECT_EQ(plate.backgroundAt(middle(x, 4)), kSky) << x;
}

TEST_F(PlateTest, FindsWhatIsDrawnOverSurfaces) {
  shown.pixels[at(5, 4)] = kText;
  for (const bool exact : {true, false}) {
    const Plate plate(shown, traced, exact);
    EXPECT_EQ(plate.overlayAt(middle(5, 4)), kText);
    EXPECT_EQ(plate.overlayAt(middle(6, 6)), 0u);
  }
}

TEST_F(PlateTest, TakesMixedNeighboursForAntialiasing) {
  const uint32_t mixed = 0xff505090;  // half of each
  shown.pixels[at(4, 4)] = shown.pixels[at(3, 4)] = mixed;
  const Plate plate(shown, traced, false);
  EXPECT_FALSE(plate.hasOverlays());
  for (int x = 0; x < kWide; ++x) EXPECT_EQ(plate.backgroundAt(middle(x, 4)), kSky) << x;
  EXPECT_EQ(Plate(shown, traced, true).overlayAt(middle(4, 4)), mixed) << "windows that are exact have none";
  EXPECT_EQ(plate.windowBackgroundAt({3, 4}), mixed) << "in the window's size";
  EXPECT_EQ(plate.windowBackgroundAt({5, 4}), kSky);
}

TEST_F(PlateTest, RoundsAsTheWindow) {
  shown.pixels[at(5, 4)] = kSurface + 0x010001;
  const Plate plate(shown, traced, true);
  EXPECT_FALSE(plate.hasOverlays());
  EXPECT_EQ(plate.roundedAsShown({5, 4}, kSurface), kSurface + 0x010001);
  EXPECT_EQ(plate.roundedAsShown({5, 4}, kSurface + 0x030000), kSurface + 0x030000);
}

}  // namespace
}  // namespace gluray::saved
