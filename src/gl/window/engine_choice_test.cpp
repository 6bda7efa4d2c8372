#include "gl/window/engine_choice.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace gluray::gl {
namespace {

using Way = EngineChoice::Way;

double g_now = 0;
int g_clockCalls = 0;
double fakeClock() { return ++g_clockCalls, g_now; }

/// A fake program whose frames take the time that the test sets.
struct Program {
  EngineChoice choice;
  double triangles = 2000, pixels = 300 * 300;
  std::function<double()> traced = [] { return 0.010; }, direct = [] { return 0.001; };
  double idle = 0;  // between frames
  int finishes = 0, traceFrames = 0, directFrames = 0, changes = 0;

  explicit Program(Engine engine = Engine::automatic) : choice(engine, 2, fakeClock) {
    g_now = 0, g_clockCalls = 0;
  }
  void frame() {
    const Way way = choice.way();
    if (choice.wantsStart()) ++finishes, choice.start();
    choice.drew(static_cast<uint64_t>(triangles), pixels);
    g_now += way == Way::traced ? traced() : direct();
    ++(way == Way::traced ? traceFrames : directFrames);
    if (choice.wantsStop()) ++finishes, choice.stop();
    g_now += idle;
    if (choice.frameEnded() != way) ++changes;
  }
  void frames(int n) {
    for (int i = 0; i < n; ++i) frame();
  }
};

TEST(EngineChoice, FixedEnginesReadNoClock) {
  for (const Engine engine : {Engine::always, Engine::never}) {
    Program p(engine);
    p.frames(1000);
    EXPECT_EQ(p.choice.way(), engine == Engine::always ? Way::traced : Way::passthrough);
    EXPECT_EQ(p.changes, 0);
    EXPECT_EQ(p.finishes, 0);
    EXPECT_EQ(g_clockCalls, 0);
  }
}

TEST(EngineChoice, TinySceneIsNeverTraced) {
  Program p;
  p.frames(100000);  // 100 seconds
  EXPECT_EQ(p.traceFrames, 0);
  EXPECT_EQ(p.changes, 1);            // from mixed
  EXPECT_LT(p.finishes, 2 * 3 * 10);  // measured again rarely
}

TEST(EngineChoice, LargeSceneIsNeverRasterised) {
  Program p;
  p.triangles = 1e6, p.pixels = 1 << 20;
  EXPECT_FALSE(p.choice.takes(1000000, p.pixels));
  p.frames(1);
  p.directFrames = 0;  // the first frame is mixed: the test counts it as direct
  p.frames(100000);
  EXPECT_EQ(p.directFrames, 0);
  EXPECT_EQ(p.finishes, 0);
  EXPECT_LT(g_clockCalls, 5);
}

TEST(EngineChoice, TracesIfThatIsFaster) {
  Program p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.050; }, p.traced = [] { return 0.020; };
  p.frames(50);
  EXPECT_EQ(p.choice.way(), Way::traced);
  EXPECT_EQ(p.changes, 2);  // mixed, direct, traced
  p.changes = 0;
  p.frames(50000);
  EXPECT_EQ(p.changes, 0);
}

TEST(EngineChoice, GoesBackAfterATrialWithoutGain) {
  Program p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.022; };
  p.frames(150);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
  EXPECT_EQ(p.traceFrames, 3);  // of one trial
}

TEST(EngineChoice, TrialThatIsLikelyToLoseIsSavedFor) {
  Program p;
  p.triangles = 3000, p.pixels = 400 * 400;
  const double direct = 0.0019;
  int traced = 0;  // the first one starts threads and builds shaders
  p.direct = [&] { return direct; }, p.traced = [&] { return ++traced == 1 ? 0.030 : 0.008; };
  p.frames(200);
  EXPECT_EQ(p.traceFrames, 0);
  while (g_now < 120) {
    p.frame();
    const double drawn = direct * (p.traceFrames + p.directFrames);
    ASSERT_LT(g_now, 1.015 * drawn) << "after " << drawn << " seconds";
  }
  EXPECT_GE(p.traceFrames, 2);  // it is tried, though
}

TEST(EngineChoice, TrialThatIsLikelyToWinIsMadeAtOnce) {
  Program p;
  p.triangles = 30000, p.pixels = 400 * 400;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.006; };
  p.frames(12);
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(EngineChoice, TrialThatIsLikelyToWinIsMadeAtOnceAfterOneThatTookLong) {
  Program p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.030; }, p.traced = [&] { return p.traceFrames == 0 ? 1.0 : 0.040; };
  p.frames(100);
  ASSERT_EQ(p.choice.way(), Way::passthrough);
  ASSERT_EQ(p.traceFrames, 3);
  p.triangles = 30000, p.pixels = 400 * 400;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.006; };
  p.frames(100);  // the larger frames are forgotten after 64
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(EngineChoice, HopelessTrialEndsWithItsSecondFrame) {
  Program p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.045; };
  p.frames(150);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
  EXPECT_EQ(p.traceFrames, 2);
}

TEST(EngineChoice, TrialsBecomeRare) {
  Program p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.022; };
  while (g_now < 3600) p.frame();
  EXPECT_LE(p.traceFrames, 3 * 8);
  EXPECT_GE(p.traceFrames, 3 * 3);
}

TEST(EngineChoice, FirstFramesDoNotCount) {
  Program p;
  int frames = 0;
  p.direct = [&] { return frames < 3 ? 0.200 : 0.001; };  // shaders are built, lists compiled
  for (; frames < 200; ++frames) p.frame();
  EXPECT_EQ(p.traceFrames, 0);
}

TEST(EngineChoice, NoiseDoesNotChangeTheWay) {
  Program p;
  p.triangles = 100000, p.pixels = 1 << 20;
  uint32_t random = 1;
  const auto noisy = [&](double seconds) {
    random = random * 1664525 + 1013904223;
    return random >> 30 == 0 ? 3 * seconds : seconds;  // one frame in four is disturbed
  };
  p.direct = [&] { return noisy(0.010); }, p.traced = [&] { return noisy(0.011); };
  p.frames(100);
  p.changes = 0;
  p.frames(20000);
  EXPECT_LE(p.changes, 2 * 5);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
}

TEST(EngineChoice, SceneThatGrowsIsTraced) {
  Program p;
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
  Program p;
  p.frames(1000);
  p.triangles = 400000;
  p.frame();
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(EngineChoice, ShrunkenSceneIsTriedInTheRealOpenGl) {
  Program p;
  p.triangles = 1e6;
  p.frames(300);
  ASSERT_EQ(p.choice.way(), Way::traced);
  p.triangles = 2000;
  p.frames(300);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
}

TEST(EngineChoice, RecurringKindsOfFramesAreRemembered) {
  Program p;
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
  Program p;
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
  Program p;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(p.choice.frameEnded(), Way::mixed);
}

TEST(EngineChoice, TakesDrawsOfTheFirstFrameUntilTheirSumIsTooLarge) {
  Program p;
  const double pixels = 100 * 100;
  const auto most = static_cast<uint64_t>(EngineChoice::mostTriangles(pixels));
  EXPECT_TRUE(p.choice.takes(most, pixels));
  p.choice.drew(most / 2, pixels);
  EXPECT_TRUE(p.choice.takes(most / 4, pixels));
  EXPECT_FALSE(p.choice.takes(most, pixels));
}

TEST(EngineChoice, TakesFewLayersInFramesOfAnyKind) {
  constexpr double kPixels = 1000000;
  const EngineChoice choice(Engine::automatic, 4);
  EXPECT_TRUE(choice.takesLayers(2, 100));
  EXPECT_TRUE(choice.takesLayers(900000, kPixels));
  EXPECT_FALSE(choice.takesLayers(1100000, kPixels));
  EXPECT_FALSE(EngineChoice(Engine::always, 4).takesLayers(2, kPixels));
}

TEST(EngineChoice, LargeScenesWithoutAChoiceAreNotMeasured) {
  Program p;
  p.triangles = 25000;
  p.frames(100);
  ASSERT_EQ(p.choice.way(), Way::traced);  // too large
  p.triangles = 2000;
  p.frames(300);
  ASSERT_EQ(p.choice.way(), Way::passthrough);
  // On more pixels these triangles are few enough, but the kind of these frames is that of the first ones.
  p.triangles = 26000, p.pixels = 134000;
  p.direct = [] { return 0.030; };
  p.choice.overflow();
  p.frames(20);
  ASSERT_EQ(p.choice.way(), Way::traced);
  p.finishes = 0;
  p.frames(1000);
  EXPECT_EQ(p.choice.way(), Way::traced);
  EXPECT_EQ(p.finishes, 0);
}

TEST(EngineChoice, NoticesWhenTheMachineBecomesFaster) {
  // Other work kept the cores busy during the trial.
  Program p;
  p.triangles = 150000, p.pixels = 1 << 20;
  bool busy = true;
  p.direct = [] { return 0.030; }, p.traced = [&] { return busy ? 0.035 : 0.015; };
  while (g_now < 3) p.frame();
  ASSERT_EQ(p.choice.way(), Way::passthrough);
  busy = false;
  while (g_now < 120) p.frame();
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(EngineChoice, NoticesWhenASlowMachineBecomesFaster) {
  // The next trial is likely to take more than can be saved.
  Program p;
  p.triangles = 150000, p.pixels = 1 << 20;
  bool busy = true;
  p.direct = [] { return 1.0; }, p.traced = [&] { return busy ? 1.2 : 0.3; };
  p.frames(20);
  ASSERT_EQ(p.choice.way(), Way::passthrough);
  ASSERT_EQ(p.traceFrames, 3);
  busy = false;
  p.frames(300);
  EXPECT_EQ(p.choice.way(), Way::traced);
}

}  // namespace
}  // namespace gluray::gl
