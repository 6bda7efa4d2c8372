// The text of the HUD.
#include "intercept/hud/hud.h"

#include "intercept/hud/text_image.h"

#include <gtest/gtest.h>

namespace gluray::intercept {
namespace {

using Lines = std::vector<std::string>;

TEST(HudLines, ShowRateAndShare) {
  HudFigures f{.seconds = 0.5, .frames = 10, .traced = 8746820, .flushes = 20, .bvhBytes = 84000000};
  EXPECT_EQ(hudLines(f), (Lines{"20.0 FPS  50.0 MS", "875 K TRIANGLES, 100 % TRACED", "BVH 84.0 MB"}));
  f.refining = true;
  EXPECT_EQ(hudLines(f).back(), "BVH 84.0 MB, IMPROVING");
}

TEST(HudLines, NeverShow100PercentIfAnythingIsRasterised) {
  const HudFigures f{.seconds = 1, .frames = 1, .traced = 999999, .rasterised = 1};
  EXPECT_EQ(hudLines(f)[1], "1.00 M TRIANGLES, 99 % TRACED");
}

TEST(HudLines, ShowWhoDraws) {
  EXPECT_EQ(hudLines({.seconds = 1, .frames = 60, .framesPassedThrough = 60, .rasterised = 60 * 880})[1],
            "880 TRIANGLES, BY OPENGL");
  EXPECT_EQ(hudLines({.seconds = 1, .frames = 60})[1], "0 TRIANGLES, NOTHING DRAWN");
  EXPECT_EQ(hudLines({.seconds = 1, .frames = 60, .framesPassedThrough = 60, .traced = 6000000})[1],
            "100 K TRIANGLES, 100 % TRACED")
      << "composed by a toolkit";
}

TEST(HudLines, ShowThatNothingChanged) {
  const HudFigures f{.seconds = 1, .frames = 9, .traced = 90, .flushes = 9, .repeated = 9, .bvhBytes = 1000};
  EXPECT_EQ(hudLines(f).back(), "BVH 1.00 KB, NOTHING CHANGED");
}

TEST(HudLines, ShowHowFarLightIsRefined) {
  HudFigures f{.seconds = 1, .frames = 9, .traced = 90, .lightPasses = 44, .lightNoise = 0.00981};
  EXPECT_EQ(hudLines(f).back(), "LIGHT 44 PASSES, NOISE 0.0098");
  f.lightNoise = 0;
  EXPECT_EQ(hudLines(f).back(), "10 TRIANGLES, 100 % TRACED");
}

TEST(HudLines, ShowTheNameBeforeAnyFigures) { EXPECT_EQ(hudLines({}), Lines{"GLURAY"}); }

TEST(HudLines, UseDrawableLetters) {
  const HudFigures all{.seconds = 0.3,
                       .frames = 7,
                       .traced = 5,
                       .rasterised = 2,
                       .flushes = 1,
                       .repeated = 1,
                       .bvhBytes = 12345678901,
                       .lightPasses = 3,
                       .lightNoise = 0.5,
                       .refining = true};
  for (const std::string& line : hudLines(all))
    for (const char letter : line) EXPECT_TRUE(isDrawable(letter)) << line << ": " << letter;
}

TEST(HudFigures, AreDifferencesExceptForStates) {
  gl::Statistics before, now;
  before.frames = 5, now.frames = 9, before.trianglesTraced = 50, now.trianglesTraced = 90;
  before.bvhBytes = 1000, now.bvhBytes = 700, now.blasRefining = 1;
  const HudFigures f = between(before, now, 2);
  EXPECT_EQ(f.frames, 4u);
  EXPECT_EQ(f.traced, 40u);
  EXPECT_EQ(f.bvhBytes, 700u);
  EXPECT_TRUE(f.refining);
}

}  // namespace
}  // namespace gluray::intercept
