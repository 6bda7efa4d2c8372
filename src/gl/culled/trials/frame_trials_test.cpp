// Whether skipping small draws pays, by a simulated program with its own clock.
#include "gl/culled/trials/frame_trials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <vector>

namespace gluray::gl {
namespace {

using FrameWay = FrameTrials::Way;

/// Costs of a program's frames, in seconds.
struct SimulatedScene {
  double plain = 0.1;                   // a frame
  double capture = 0.03;                // all of its draws
  double build = 0;                     // boxes of all draws
  double look = 0.002, overlap = 0;     // a depth read; the extra cost of waiting for it
  std::function<bool(double)> hidden =  // whether the draw at this share of the frame is, behind others
      [](double) { return false; };
  double outside = 0;  // share of the draws that are not in the view
  int contents = 20;   // different ones
  double vertices = 1e6;
  bool changes = false;  // contents are new in each frame
  double warming = 0;    // of the first frame
};

class SimulatedProgram {
 public:
  static constexpr int kDraws = 400, kLooks = 8;

  /// Draws `frames` frames and appends their costs, as shares of a plain frame.
  void draw(const SimulatedScene& scene, int frames) {
    for (int i = 0; i < frames; ++i) {
      const double began = now_;
      frame(scene);
      shares.push_back((now_ - began) / scene.plain);
    }
  }
  /// The largest mean cost of `window` consecutive frames.
  double worst(size_t window, size_t from = 12) const {
    double most = 0;
    for (size_t i = from; i + window <= shares.size(); ++i)
      most = std::max(most, std::accumulate(shares.begin() + std::ptrdiff_t(i),
                                            shares.begin() + std::ptrdiff_t(i + window), 0.0) /
                                double(window));
    return most;
  }
  /// Culled frames until now.
  int culled() const { return int(std::ranges::count(ways, FrameWay::culled)); }

  FrameTrials trials;
  std::vector<double> shares;
  std::vector<FrameWay> ways;

 private:
  void frame(const SimulatedScene& s) {
    const FrameWay way = trials.nextFrame(false, last_);
    ways.push_back(way), ++frames_;
    if (trials.isMeasured()) trials.start(now_);
    if (frames_ == 1) now_ += s.warming;
    for (int d = 0; d < kDraws; ++d)
      if (way == FrameWay::plain || !trials.takes(d) || !leavesOut(s, way, d)) now_ += s.plain / kDraws;
    last_ = {kDraws, s.vertices, kDraws, double(waiting_)};
    if (!trials.wantsStop()) return;
    trials.stop(now_);
    EXPECT_FALSE(trials.wantsStop());
  }
  bool leavesOut(const SimulatedScene& s, FrameWay way, int d) {
    const double began = now_;
    now_ += s.capture / kDraws;
    const bool known = isKnown(s, d);
    trials.worked(trials.isTimed() ? now_ - began : trials.drawSeconds());
    if (!known) return trials.isUnknown(), false;
    trials.isBoxed(s.vertices / kDraws);
    const double at = double(d) / kDraws;
    if (way == FrameWay::culled && d % (kDraws / kLooks) == 0) {
      now_ += s.look;
      trials.looked(s.look, now_);
      now_ += s.overlap;
    }
    const bool hides = double(d % 100) < 100 * s.outside || (way == FrameWay::culled && s.hidden(at));
    if (hides) trials.leftOut(1);
    return hides;
  }
  /// Boxes are built in the second frame that has the content.
  bool isKnown(const SimulatedScene& s, int d) {
    if (s.changes) return ++waiting_, false;
    auto [at, isNew] = seen_.try_emplace(d % s.contents, frames_);
    waiting_ += isNew;
    if (at->second == frames_) return false;
    if (at->second > 0) now_ += s.build / s.contents, at->second = 0, --waiting_;
    return true;
  }

  double now_ = 0;
  int frames_ = 0, waiting_ = 0;
  std::map<int, int> seen_;  // contents: the first frame that had them; 0: they have boxes
  FrameTrials::Load last_;
};

constexpr double kMaxShare = 1.03;    // of the plain program's time, in any second or so
constexpr size_t kWindowFrames = 64;  // frames

const auto kHiddenLate = [](double at) { return at > 0.2; };

TEST(FrameTrials, CullWhereItPaysWithinSomeFrames) {
  SimulatedProgram program;
  program.draw({.build = 0.02, .hidden = kHiddenLate, .warming = 0.3}, 30);
  EXPECT_TRUE(program.trials.pays());
  EXPECT_LT(program.ways.size() - size_t(program.culled()), 20u);
  EXPECT_LT(program.worst(30, 0), 1.2);
  program.draw({.hidden = kHiddenLate}, 2000);
  EXPECT_GT(program.culled(), 2030 - 50) << "measured again from time to time";
  SimulatedProgram beside;  // most is outside of the view
  beside.draw({.outside = 0.6}, 40);
  EXPECT_TRUE(beside.trials.pays());
}

TEST(FrameTrials, CostNextToNothingWhereItDoesNotPay) {
  for (const double capture : {0.01, 0.03, 0.05, 0.1, 0.4})
    for (const double build : {0.0, 0.05, 0.5}) {
      SimulatedProgram program;
      program.draw({.capture = capture, .build = build, .warming = 0.5}, 6000);
      EXPECT_FALSE(program.trials.pays());
      EXPECT_GT(program.culled(), 5) << "it is tried";
      EXPECT_LT(program.culled(), 60) << "more and more rarely";
      EXPECT_LT(program.worst(kWindowFrames), kMaxShare) << capture << ", boxes " << build;
      EXPECT_LT(program.worst(5000, 1000), 1.002);
    }
}

TEST(FrameTrials, CostLittleWhereSomeIsHiddenButNotEnough) {
  for (const double from : {0.5, 0.7, 0.9})
    for (const double overlap : {0.0, 0.004, 0.02}) {
      SimulatedProgram program;
      program.draw({.capture = 0.09, .overlap = overlap, .hidden = [=](double at) { return at > from; }},
                   6000);
      EXPECT_LT(program.worst(kWindowFrames), kMaxShare) << from << ", overlap " << overlap;
    }
}

TEST(FrameTrials, WaitForBoxesThatTakeLong) {
  SimulatedProgram program;
  const SimulatedScene scene{.build = 0.3, .hidden = kHiddenLate, .contents = SimulatedProgram::kDraws};
  program.draw(scene, 60);
  EXPECT_EQ(program.culled(), 0);
  EXPECT_LT(program.worst(40), kMaxShare);
  program.draw(scene, 240);
  EXPECT_TRUE(program.trials.pays());
}

TEST(FrameTrials, GiveUpWhereContentsAlwaysChange) {
  SimulatedProgram program;
  program.draw({.hidden = kHiddenLate, .changes = true}, 4000);
  EXPECT_EQ(program.culled(), 0);
  EXPECT_LT(program.worst(kWindowFrames), kMaxShare);
}

TEST(FrameTrials, LeaveFewOrLightDrawsAlone) {
  FrameTrials trials;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(trials.nextFrame(false, {20, 1e6, 20}), FrameWay::plain);
    EXPECT_FALSE(trials.isMeasured());
    EXPECT_EQ(trials.nextFrame(false, {1000, 1e4, 1000}), FrameWay::plain);
    EXPECT_FALSE(trials.isMeasured());
  }
}

TEST(FrameTrials, AlwaysCulledFramesNeverGiveUp) {
  FrameTrials trials;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(trials.nextFrame(true, {1, 3, 1}), FrameWay::culled);
    EXPECT_FALSE(trials.isMeasured());
    EXPECT_TRUE(trials.takes(0));
    trials.worked(1e9), trials.looked(1e9, 1e9);
    EXPECT_TRUE(trials.takes(1));
  }
}

TEST(FrameTrials, FollowScenesThatChange) {
  const SimulatedScene pays{.hidden = kHiddenLate}, costs{.capture = 0.05};
  SimulatedProgram program;
  program.draw(pays, 100);
  EXPECT_TRUE(program.trials.pays());
  program.draw(costs, 300);
  EXPECT_FALSE(program.trials.pays()) << "draws that are not hidden any more end it soon";
  EXPECT_LT(program.worst(kWindowFrames), kMaxShare);
  program.draw(pays, 600);
  EXPECT_TRUE(program.trials.pays());
  // So little is hidden that culling costs time, but not enough to end a frame early.
  SimulatedScene weak = pays;
  weak.capture = 0.03, weak.look = 0, weak.hidden = [](double at) { return at > 0.72; };
  program.draw(weak, 200);
  EXPECT_FALSE(program.trials.pays());
}

TEST(FrameTrials, CostLittleWhereTheLoadAlwaysChanges) {
  for (const int each : {1, 3, 10, 40}) {
    SimulatedProgram program;
    for (int i = 0; i < 4000 / each; ++i)
      program.draw({.capture = 0.06, .vertices = i % 2 ? 1e6 : 4e6}, each);
    EXPECT_LT(program.worst(kWindowFrames), kMaxShare) << each;
  }
}

TEST(FrameTrials, FindThatItPaysInAHeavierScene) {
  SimulatedProgram program;
  program.draw({.capture = 0.05}, 1000);
  EXPECT_FALSE(program.trials.pays());
  program.draw({.plain = 0.4, .hidden = kHiddenLate, .vertices = 4e6}, 150);
  EXPECT_TRUE(program.trials.pays()) << "the hold ends sooner";
}

}  // namespace
}  // namespace gluray::gl
