// Small draws with `cull.draws = auto`: frames in which draws are left out from some draw on, or until some
// draw, while GLuRay measures whether it pays.
#include "tests/reference/culled/timed_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

/// Rows of seven balls.
void rows(Gl gl, const SmallScene& s, int count, float distance, int frame, float aside = 0) {
  for (int i = 0; i < count; ++i)
    s.balls(gl, distance + 0.05f * static_cast<float>(i), aside + 0.01f * static_cast<float>(frame));
}

/// Most is hidden, and little costs: culled in the end.
void mostlyHidden(Gl gl, const SmallScene& s, int frame) { s.wallSeen(gl), rows(gl, s, 14, 6, frame); }

void expectCulled(const std::vector<uint64_t>& leftOut) {
  EXPECT_EQ(leftOut[0] + leftOut[1] + leftOut[2], 0u) << "plain frames are measured first";
  for (size_t i = leftOut.size() - 10; i < leftOut.size(); ++i) EXPECT_GT(leftOut[i], 14 * 4u) << i;
}

TEST(SmallDrawsTrials, EndCulledWhereItPays) {
  expectCulled(compareTimedFrames("trials_pay", 40, mostlyHidden, [] { return 1e-3; }));
}

TEST(SmallDrawsTrials, ThatPayAreVerified) {
  expectCulled(compareTimedFrames(
      "trials_pay_verified", 40, mostlyHidden, [] { return 1e-3; }, 1));
}

/// Draws that were left out of a frame.
struct LeftOut {
  uint64_t first = 0, hidden = 0, last = 0;  // out of the view, behind the wall, and out of the view again
};

/// Some is hidden and some is out of the view, but most is before the wall.
LeftOut mostlySeen(Gl gl, const SmallScene& s, int frame) {
  auto since = [last = uint64_t{0}]() mutable {
    const uint64_t now = g_time.context->counts.statistics.drawsCulled;
    return now - std::exchange(last, now);
  };
  since();
  LeftOut out;
  rows(gl, s, 1, 6, frame, 30), out.first = since();
  s.wallSeen(gl), rows(gl, s, 2, 6, frame), out.hidden = since();
  rows(gl, s, 16, 3.2f, frame), since();
  rows(gl, s, 1, 6, frame, 30), out.last = since();
  return out;
}

void expectGivenUp(int verify) {
  std::vector<LeftOut> frames;
  compareTimedFrames(
      "trials_cost" + std::to_string(verify), 60,
      [&](Gl gl, const SmallScene& s, int frame) { frames.push_back(mostlySeen(gl, s, frame)); },
      [] { return 0.5; }, verify);
  frames.erase(frames.begin(), frames.begin() + 60);  // those that are whole
  const auto any = [&](const auto& is) { return std::ranges::any_of(frames, is); };
  EXPECT_TRUE(any([](const LeftOut& f) { return f.hidden > 0 && f.last == 0; })) << "given up";
  EXPECT_TRUE(any([](const LeftOut& f) { return f.first > 0 && f.hidden + f.last == 0; }))
      << "boxes were made until there was no time left";
  EXPECT_TRUE(any([](const LeftOut& f) { return f.first + f.hidden == 0 && f.last > 0; })) << "and later on";
  for (size_t i = 55; i < 60; ++i) EXPECT_EQ(frames[i].first + frames[i].hidden + frames[i].last, 0u) << i;
}

TEST(SmallDrawsTrials, AreGivenUpInTheMiddleOfAFrame) { expectGivenUp(0); }

TEST(SmallDrawsTrials, ThatAreGivenUpAreVerified) { expectGivenUp(1); }

}  // namespace
}  // namespace gluray::test
