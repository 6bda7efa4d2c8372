// Precedents, and what EngineChoice makes of them.
#include "gl/trials/precedents.h"

#include "gl/testing/fake_program.h"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

namespace gluray::gl {
namespace {

using test::FakeProgram, test::Way, test::g_now;

/// A program with `triangles` on a million pixels.
FakeProgram program(double triangles, double traced, double direct, std::shared_ptr<Precedents> precedents,
                    bool software = true) {
  FakeProgram p(Engine::automatic, software, std::move(precedents));
  p.triangles = triangles, p.pixels = 1 << 20;
  p.traced = [=] { return traced; }, p.direct = [=] { return direct; };
  return p;
}

TEST(Precedents, FindsTheMostSimilarLoad) {
  Precedents precedents;
  precedents.add({{100000, 1e6}, 1, 2});
  precedents.add({{160000, 1e6}, 3, 4});
  ASSERT_TRUE(precedents.find({140000, 1e6}));
  EXPECT_EQ(precedents.find({140000, 1e6})->traced, 3);
  EXPECT_EQ(precedents.find({110000, 1e6})->traced, 1);
  EXPECT_FALSE(precedents.find({140000, 2e6}));
  EXPECT_FALSE(precedents.find({1000000, 1e6}));
}

TEST(Precedents, ReplacesSimilarOnesAndTheOldest) {
  Precedents precedents;
  for (size_t i = 0; i <= Precedents::kMost; ++i) precedents.add({{10000, 1e3 * (1 << (2 * i % 40))}, 1, 2});
  const size_t before = precedents.all().size();
  precedents.add({{10000, 1e3}, 5, 6});
  EXPECT_EQ(precedents.all().size(), before);
  EXPECT_EQ(precedents.find({10000, 1e3})->traced, 5);
  double pixels = 10;
  for (size_t i = 0; i < 2 * Precedents::kMost; ++i) precedents.add({{10000, pixels *= 1.6}, 1, 2});
  EXPECT_EQ(precedents.all().size(), Precedents::kMost);
  EXPECT_TRUE(precedents.find({10000, pixels}));
  EXPECT_FALSE(precedents.find({10000, 16}));
}

TEST(Precedents, IgnoresWhatIsNoTime) {
  Precedents precedents;
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, inf}) {
    precedents.add({{1000, 1000}, bad, 1});
    precedents.add({{1000, 1000}, 1, bad});
  }
  precedents.add({{nan, 1000}, 1, 1});
  precedents.add({{1000, -1}, 1, 1});
  EXPECT_TRUE(precedents.all().empty());
}

TEST(Precedents, AnotherContextUsesTheFasterWayAtOnce) {
  const auto precedents = std::make_shared<Precedents>();
  FakeProgram first = program(150000, 0.020, 0.050, precedents);
  first.frames(50);
  ASSERT_EQ(first.choice.way(), Way::traced);
  ASSERT_EQ(precedents->all().size(), 1u);
  FakeProgram second = program(150000, 0.020, 0.050, precedents);
  second.frames(2000);
  EXPECT_EQ(second.choice.way(), Way::traced);
  EXPECT_EQ(second.directFrames, 1);  // before anything was known
}

TEST(Precedents, LosingTrialIsNotRepeatedInAnotherContext) {
  const auto precedents = std::make_shared<Precedents>();
  FakeProgram first = program(150000, 0.022, 0.020, precedents);
  first.frames(150);
  ASSERT_EQ(first.traceFrames, 3);
  FakeProgram second = program(150000, 0.022, 0.020, precedents);
  second.frames(1000);  // 20 seconds
  EXPECT_EQ(second.traceFrames, 0);
  while (g_now < 600) second.frame();
  EXPECT_GE(second.traceFrames, 3) << "it is tried again later";
}

TEST(Precedents, LargeScenesThatTheRealOpenGlDrawsFasterAreNotTracedFirst) {
  const auto precedents = std::make_shared<Precedents>();
  FakeProgram first = program(500000, 0.400, 0.060, precedents);
  while (g_now < 60) first.frame();
  ASSERT_EQ(first.choice.way(), Way::passthrough);
  FakeProgram second = program(500000, 0.400, 0.060, precedents);
  second.frames(500);
  EXPECT_EQ(second.traceFrames, 0);
  // A larger scene is unknown again.
  second.triangles = 2e6;
  second.frame();
  EXPECT_EQ(second.choice.way(), Way::traced);
}

TEST(Precedents, HardwareNeedsNoSavingsWhereTracingWasFaster) {
  const auto precedents = std::make_shared<Precedents>();
  precedents->add({{4e6, 1 << 20}, 0.020, 0.050});
  FakeProgram p = program(4e6, 0.020, 0.050, precedents, false);
  p.frames(100);
  EXPECT_EQ(p.choice.way(), Way::traced);
  EXPECT_EQ(p.directFrames, 1);
}

TEST(Precedents, OneThatIsNotMetIsReplacedByATrial) {
  // Frames took 20 ms when they were traced. Now they take 100, because structures are built anew.
  const auto precedents = std::make_shared<Precedents>();
  precedents->add({{150000, 1 << 20}, 0.020, 0.050});
  FakeProgram p = program(150000, 0.100, 0.050, precedents);
  while (g_now < 10) p.frame();
  EXPECT_EQ(p.choice.way(), Way::passthrough);
  ASSERT_EQ(precedents->all().size(), 1u);
  EXPECT_GT(precedents->all()[0].traced, precedents->all()[0].direct);
}

TEST(Precedents, WrongOneOfTheSameTimeLastsForAMinute) {
  // Frames of the real OpenGL have become faster, which no traced frame tells.
  const auto precedents = std::make_shared<Precedents>();
  precedents->add({{150000, 1 << 20}, 0.020, 0.050});
  FakeProgram p = program(150000, 0.020, 0.004, precedents);
  while (g_now < 120) p.frame();
  EXPECT_EQ(p.choice.way(), Way::passthrough);
}

}  // namespace
}  // namespace gluray::gl
