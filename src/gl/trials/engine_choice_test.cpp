// Which engine draws frames of different sizes and kinds.
#include "gl/testing/fake_program.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using test::FakeProgram, test::Way, test::g_clockCalls;

TEST(EngineChoice, FixedEnginesReadNoClock) {
  for (const Engine engine : {Engine::always, Engine::never}) {
    FakeProgram p(engine);
    p.frames(1000);
    EXPECT_EQ(p.choice.way(), engine == Engine::always ? Way::traced : Way::passthrough);
    EXPECT_EQ(p.changes, 0);
    EXPECT_EQ(p.finishes, 0);
    EXPECT_EQ(g_clockCalls, 0);
  }
}

TEST(EngineChoice, TinySceneIsNeverTraced) {
  FakeProgram p;
  p.frames(100000);  // 100 seconds
  EXPECT_EQ(p.traceFrames, 0);
  EXPECT_EQ(p.changes, 1);            // from mixed
  EXPECT_LT(p.finishes, 2 * 3 * 10);  // measured again rarely
}

TEST(EngineChoice, LargeSceneIsNeverRasterised) {
  FakeProgram p;
  p.triangles = 1e6, p.pixels = 1 << 20;
  EXPECT_FALSE(p.choice.takes(1000000, p.pixels));
  p.frames(1);
  p.directFrames = 0;  // the first frame is mixed: the test counts it as direct
  p.frames(100000);
  EXPECT_EQ(p.directFrames, 0);
  EXPECT_LT(p.finishes, 2 * 3 * 30);  // measured again rarely, in 1000 seconds
}

TEST(EngineChoice, SceneThatGrowsIsTraced) {
  FakeProgram p;
  p.frames(1000);
  ASSERT_EQ(p.choice.way(), Way::passthrough);
  // The real OpenGL does not take a large draw, and the frame becomes mixed.
  EXPECT_FALSE(p.choice.takes(500000, p.pixels));
  p.choice.overflow();
  EXPECT_EQ(p.choice.way(), Way::mixed);
  EXPECT_TRUE(p.choice.takes(1000, p.pixels));
  p.triangles = 502000;
  p.frame();
  EXPECT_EQ(p.choice.way(), Way::traced);
  p.frames(1000);
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(EngineChoice, ManySmallDrawsAreTracedIfTheirSumIsTooLarge) {
  FakeProgram p;
  p.frames(1000);
  p.triangles = 400000;
  p.frame();
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(EngineChoice, ShrunkenSceneIsTriedInTheRealOpenGl) {
  FakeProgram p;
  p.triangles = 1e6;
  p.frames(300);
  ASSERT_EQ(p.choice.way(), Way::traced);
  p.triangles = 2000;
  p.frames(300);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
}

TEST(EngineChoice, RecurringKindsOfFramesAreRemembered) {
  FakeProgram p;
  const auto kind = [&](bool heavy) {
    p.triangles = heavy ? 150000 : 2000, p.pixels = 1 << 20;
    p.direct = [heavy] { return heavy ? 0.060 : 0.002; };
    p.traced = [] { return 0.020; };
  };
  for (int i = 0; i < 2; ++i) kind(i == 0), p.frames(1000);
  p.changes = 0;
  for (int i = 0; i < 10; ++i) {
    kind(i % 2 == 0);
    p.frames(1000);
    EXPECT_EQ(p.choice.way(), i % 2 == 0 ? Way::traced : Way::passthrough);
  }
  EXPECT_EQ(p.changes, 10);  // no trials: one change each
}

TEST(EngineChoice, LargeFramesDecideAmongSmallOnes) {
  // Two targets in turn: the large one decides.
  FakeProgram p;
  int frame = 0;
  const auto heavy = [&] { return frame % 2 == 0; };
  p.direct = [&] { return heavy() ? 0.050 : 0.0005; };
  p.traced = [&] { return heavy() ? 0.020 : 0.001; };
  for (; frame < 2000; ++frame) {
    p.triangles = heavy() ? 150000 : 500, p.pixels = heavy() ? 1 << 20 : 1 << 14;
    p.frame();
  }
  EXPECT_EQ(p.choice.way(), Way::traced);
  EXPECT_LE(p.changes, 4);
}

TEST(EngineChoice, EmptyFramesDecideNothing) {
  FakeProgram p;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(p.choice.frameEnded(), Way::mixed);
}

TEST(EngineChoice, TakesDrawsOfTheFirstFrameUntilTheirSumIsTooLarge) {
  FakeProgram p;
  const double pixels = 100 * 100;
  const auto most = static_cast<uint64_t>(EngineChoice::mostTriangles(pixels));
  EXPECT_TRUE(p.choice.takes(most, pixels));
  p.choice.drew(most / 2, pixels);
  EXPECT_TRUE(p.choice.takes(most / 4, pixels));
  EXPECT_FALSE(p.choice.takes(most, pixels));
}

TEST(EngineChoice, TakesFewLayersInFramesOfAnyKind) {
  constexpr double kPixels = 1000000;
  const EngineChoice choice({Engine::automatic, 4});
  EXPECT_TRUE(choice.takesLayers(2, 100));
  EXPECT_TRUE(choice.takesLayers(900000, kPixels));
  EXPECT_FALSE(choice.takesLayers(1100000, kPixels));
  EXPECT_FALSE(EngineChoice({Engine::always, 4}).takesLayers(2, kPixels));
}

}  // namespace
}  // namespace gluray::gl
