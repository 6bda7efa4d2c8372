// Trials of tracing: when they are made, what they decide, and how much time they cost.
#include "gl/testing/fake_program.h"

#include <gtest/gtest.h>

namespace gluray::gl {
namespace {

using test::FakeProgram, test::Way, test::g_now;

TEST(EngineChoice, TracesIfThatIsFaster) {
  FakeProgram p;
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
  FakeProgram p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.022; };
  p.frames(150);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
  EXPECT_EQ(p.traceFrames, 3);  // of one trial
}

TEST(EngineChoice, TrialThatIsLikelyToLoseIsSavedFor) {
  FakeProgram p;
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
  FakeProgram p;
  p.triangles = 30000, p.pixels = 400 * 400;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.006; };
  p.frames(12);
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(EngineChoice, TrialThatIsLikelyToWinIsMadeAtOnceAfterOneThatTookLong) {
  FakeProgram p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.030; }, p.traced = [&] { return p.traceFrames == 0 ? 0.2 : 0.040; };
  p.frames(100);
  ASSERT_EQ(p.choice.way(), Way::passthrough);
  ASSERT_EQ(p.traceFrames, 3);
  p.triangles = 30000, p.pixels = 400 * 400;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.006; };
  p.frames(100);  // the larger frames are forgotten after 64
  EXPECT_EQ(p.choice.way(), Way::traced);
}

TEST(EngineChoice, HopelessTrialEndsWithItsSecondFrame) {
  FakeProgram p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.045; };
  p.frames(150);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
  EXPECT_EQ(p.traceFrames, 2);
}

TEST(EngineChoice, TrialsBecomeRare) {
  FakeProgram p;
  p.triangles = 150000, p.pixels = 1 << 20;
  p.direct = [] { return 0.020; }, p.traced = [] { return 0.022; };
  while (g_now < 3600) p.frame();
  EXPECT_LE(p.traceFrames, 3 * 8);
  EXPECT_GE(p.traceFrames, 3 * 3);
}

TEST(EngineChoice, FirstFramesDoNotCount) {
  FakeProgram p;
  int frames = 0;
  p.direct = [&] { return frames < 3 ? 0.200 : 0.001; };  // shaders are built, lists compiled
  for (; frames < 200; ++frames) p.frame();
  EXPECT_EQ(p.traceFrames, 0);
}

TEST(EngineChoice, NoiseDoesNotChangeTheWay) {
  FakeProgram p;
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

TEST(EngineChoice, LargeScenesStayTracedWhereThatTakesNoLongerThanUsual) {
  FakeProgram p;
  p.triangles = 500000, p.pixels = 1 << 20;
  p.direct = [] { return 0.090; }, p.traced = [] { return 0.039; };
  while (g_now < 600) p.frame();
  EXPECT_EQ(p.choice.way(), Way::traced);
  EXPECT_EQ(p.directFrames, 1);  // the first one, before anything was known
}

TEST(EngineChoice, LargeScenesAreTriedWhereTracingTakesLong) {
  FakeProgram p;  // as if meshes changed in each frame
  p.triangles = 500000, p.pixels = 1 << 20;
  p.direct = [] { return 0.090; }, p.traced = [] { return 0.150; };
  p.frames(30);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
  EXPECT_TRUE(p.choice.takesAlone(500000, 1 << 20));
  EXPECT_FALSE(p.choice.takesAlone(5000000, 1 << 20));
  const int traced = p.traceFrames;
  while (g_now < 60) p.frame();
  EXPECT_LE(p.traceFrames, traced + 3 * 3);
  EXPECT_EQ(p.choice.way(), Way::passthrough);
  p.triangles = 3e6;  // too large for what is known
  p.frames(3);
  EXPECT_NE(p.choice.way(), Way::passthrough);
}

TEST(EngineChoice, LargeScenesThatLoseATrialGoBack) {
  FakeProgram p;
  p.triangles = 500000, p.pixels = 1 << 20;
  p.direct = [] { return 0.140; }, p.traced = [] { return 0.150; };
  p.frames(30);
  EXPECT_EQ(p.choice.way(), Way::traced);
  EXPECT_EQ(p.directFrames, 1 + 3);
}

TEST(EngineChoice, HardwareDrawsScenesOfAnySize) {
  FakeProgram p(Engine::automatic, false);
  p.triangles = 4e6, p.pixels = 1 << 20;
  p.direct = [] { return 0.002; }, p.traced = [] { return 0.008; };
  while (g_now < 600) p.frame();
  EXPECT_EQ(p.traceFrames, 0);
  EXPECT_TRUE(p.choice.takes(100000000, 100 * 100));
  EXPECT_TRUE(p.choice.takesLayers(100000000, 100 * 100));
}

TEST(EngineChoice, TracingIsTriedAboveSlowHardwareOnceItsLossIsSaved) {
  FakeProgram p(Engine::automatic, false);
  p.triangles = 4e6, p.pixels = 1 << 20;
  p.direct = [] { return 0.030; };
  p.traced = [&] { return p.traceFrames == 0 ? 1.2 : 0.010; };
  double firstTrial = 0;
  while (g_now < 300) {
    p.frame();
    if (p.traceFrames == 1 && firstTrial == 0) firstTrial = g_now;
  }
  EXPECT_EQ(p.choice.way(), Way::traced);
  EXPECT_GT(firstTrial, 1.2 / 0.05);  // the loss is at most 5 % of the time until then
}

TEST(EngineChoice, TracingThatCostsMoreThanCanBeSavedIsNotTriedAboveHardware) {
  FakeProgram p(Engine::automatic, false);
  p.triangles = 1e8, p.pixels = 1 << 20;
  p.direct = [] { return 0.100; }, p.traced = [&] { return p.traceFrames == 0 ? 30 : 0.020; };
  while (g_now < 3600) p.frame();
  EXPECT_EQ(p.traceFrames, 0);
}

TEST(EngineChoice, NoticesWhenTheMachineBecomesFaster) {
  // Other work kept the cores busy during the trial.
  FakeProgram p;
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
  FakeProgram p;
  p.triangles = 150000, p.pixels = 1 << 20;
  bool busy = true;
  p.direct = [] { return 1.0; }, p.traced = [&] { return busy ? 1.2 : 0.3; };
  p.frames(40);
  ASSERT_EQ(p.choice.way(), Way::passthrough);
  ASSERT_EQ(p.traceFrames, 3);
  busy = false;
  p.frames(300);
  EXPECT_EQ(p.choice.way(), Way::traced);
}

}  // namespace
}  // namespace gluray::gl
