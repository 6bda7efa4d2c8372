// How idle programs are made to draw, with a fake program and a fake clock.
#include "control/link/program/waker.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

namespace gluray::control {
namespace {

using nlohmann::json;

/// A program that has drawn its scene once.
struct SleepingProgram final : ControlledProgram {
  enum class Kind { draws, shows, sleeps, neverDraws };
  json identity() override { return {}; }
  Figures figures() override { return {0, 0, 0, scene}; }
  json state() override { return {}; }
  Called call(const std::string&, const json&, json&, std::string&) override { return Called::done; }
  void wake() noexcept override {
    asked += 'e';
    if (kind == Kind::draws) ++scene;
    if (kind != Kind::sleeps) frame();
  }
  void tellSize(bool wider) noexcept override {
    asked += wider ? 'w' : 'n';
    if (kind == Kind::shows) ++scene;
    frame();
  }
  void frame() { source.beginFrame(), source.endFrame(); }

  Kind kind = Kind::draws;
  SettingsSource source;
  uint64_t scene = 1;
  std::string asked;
};

struct WakerTest : testing::Test {
  /// The requests that the program receives within a second.
  std::string wake(SleepingProgram::Kind kind) {
    program.kind = kind, program.asked.clear();
    waker->wake();
    for (int i = 0; i < 100; ++i) waker->passed(now += 0.01);
    EXPECT_GT(waker->nextDue(now), now + 100) << "it rests";
    return program.asked;
  }
  using Kind = SleepingProgram::Kind;
  SleepingProgram program;
  std::optional<Waker> waker{std::in_place, program, program.source};
  double now = 1;
};

TEST_F(WakerTest, MostProgramsDrawWhenTheyAreExposed) {
  EXPECT_EQ(wake(Kind::draws), "e");
  EXPECT_EQ(wake(Kind::draws), "e");
  EXPECT_EQ(wake(Kind::sleeps), "e");
  program.scene = 0;
  EXPECT_EQ(wake(Kind::shows), "e") << "there is no scene";
}

TEST_F(WakerTest, ProgramsThatOnlyShowWhatTheyDrewAreToldAnotherSize) {
  EXPECT_EQ(wake(Kind::shows), "ewn");
  EXPECT_EQ(wake(Kind::shows), "wn") << "it is known";
}

TEST_F(WakerTest, AnotherSizeDisturbsUntilTheProgramHasDrawnInItsOwn) {
  wake(Kind::draws);
  EXPECT_FALSE(waker->disturbs(now));
  program.kind = Kind::shows, program.asked.clear();
  waker->wake();
  bool disturbed = false;
  while (program.asked != "ewn") {
    waker->passed(now += 0.01);
    EXPECT_EQ(waker->disturbs(now), program.asked.size() > 1) << program.asked;
    disturbed = disturbed || waker->disturbs(now);
  }
  EXPECT_TRUE(disturbed);
  EXPECT_TRUE(waker->disturbs(now + Waker::kCalm / 2));
  EXPECT_FALSE(waker->disturbs(now + 2 * Waker::kCalm));
}

TEST_F(WakerTest, ProgramsThatDoNotDrawThenAreToldNoMoreSizes) {
  EXPECT_EQ(wake(Kind::neverDraws), "ewn");
  EXPECT_EQ(wake(Kind::neverDraws), "ewn");
  EXPECT_EQ(wake(Kind::neverDraws), "e");
}

TEST_F(WakerTest, RequestsMeanwhileAreNotLost) {
  wake(Kind::shows);
  program.asked.clear();
  waker->wake(), waker->passed(now);
  waker->wake();
  for (int i = 0; i < 100; ++i) waker->passed(now += 0.01);
  EXPECT_EQ(program.asked, "wnwn");
}

TEST_F(WakerTest, WindowsHaveTheirOwnSizeAtTheEnd) {
  wake(Kind::shows);
  program.asked.clear();
  waker->wake(), waker->passed(now);
  waker.reset();
  EXPECT_EQ(program.asked, "wn");
}

}  // namespace
}  // namespace gluray::control
