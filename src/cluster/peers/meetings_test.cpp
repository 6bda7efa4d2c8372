#include "cluster/peers/meetings.h"

#include <gtest/gtest.h>

namespace gluray::cluster {
namespace {

using State = Meetings::State;

SceneHeld sceneOf(int rank, uint64_t frame, int width = 100) {
  SceneHeld scene;
  scene.address.from = rank;
  scene.frame = frame;
  scene.swaps = 1;  // of programs that do not swap
  scene.viewport = {0, 0, width, 100};
  scene.lower = glm::vec3(0), scene.upper = glm::vec3(1);
  return scene;
}

TEST(Meetings, PeersOfOneFrameMeet) {
  Meetings meetings(0, 2);
  meetings.begin(sceneOf(0, 1), 0);
  EXPECT_EQ(meetings.stateOf(1, 0), State::awaited);
  meetings.holds(sceneOf(1, 1));
  EXPECT_EQ(meetings.stateOf(1, 0.01), State::here);
  EXPECT_EQ(meetings.eyeFromPeer(1), glm::dmat4(1));
}

TEST(Meetings, ScenesOfTheFrameBeforeAndOfOtherViewsAreNotMet) {
  Meetings meetings(0, 2);
  meetings.begin(sceneOf(0, 1), 0);
  meetings.holds(sceneOf(1, 1));
  EXPECT_EQ(meetings.stateOf(1, 0), State::here);
  meetings.end();
  meetings.begin(sceneOf(0, 2), 10);
  EXPECT_EQ(meetings.stateOf(1, 10.5), State::awaited);
  meetings.holds(sceneOf(1, 2, 30));
  EXPECT_EQ(meetings.stateOf(1, 10.6), State::awaited);
  meetings.holds(sceneOf(1, 2));
  EXPECT_EQ(meetings.stateOf(1, 10.7), State::here);
}

TEST(Meetings, PeersThatDrawNothingAreAwaitedOnce) {
  Meetings meetings(0, 2);
  meetings.begin(sceneOf(0, 1), 0);
  EXPECT_EQ(meetings.stateOf(1, 0.9), State::awaited);
  EXPECT_EQ(meetings.stateOf(1, 1.1), State::absent);
  EXPECT_EQ(meetings.newlyLate(), std::vector<int>{1});
  EXPECT_TRUE(meetings.newlyLate().empty());
  meetings.end();
  meetings.begin(sceneOf(0, 2), 10);
  EXPECT_EQ(meetings.stateOf(1, 10), State::absent);
  meetings.holds(sceneOf(1, 2));
  EXPECT_EQ(meetings.stateOf(1, 10), State::here);
  meetings.end();
  meetings.begin(sceneOf(0, 3), 11);
  EXPECT_EQ(meetings.stateOf(1, 11), State::awaited);
}

TEST(Meetings, PeersThatBuildStructuresAreAwaitedLonger) {
  Meetings meetings(0, 2);
  meetings.begin(sceneOf(0, 1), 0);
  for (double now = 0; now < 5; now += 0.2) {
    meetings.comes(1, sceneOf(1, 1).viewport, now);
    EXPECT_EQ(meetings.stateOf(1, now), State::awaited);
  }
  EXPECT_EQ(meetings.stateOf(1, 7), State::absent);
  // Another view is no reason to wait.
  meetings.comes(1, sceneOf(1, 1, 30).viewport, 7);
  EXPECT_EQ(meetings.stateOf(1, 7), State::absent);
}

TEST(Meetings, CountsThatDifferByAConstantAreFoundOut) {
  Meetings meetings(0, 2);
  for (uint64_t frame = 1; frame < 4; ++frame) {
    const double now = static_cast<double>(frame);
    meetings.begin(sceneOf(0, frame), now);
    meetings.holds(sceneOf(1, frame + 7));
    EXPECT_EQ(meetings.stateOf(1, now), frame == 1 ? State::awaited : State::here);
    EXPECT_EQ(meetings.stateOf(1, now + 0.2), State::here);
    meetings.end();
  }
}

/// This rank draws nothing in frame 2, for which the peer waits.
TEST(Meetings, FramesOfProgramsThatSwapAreKeptApart) {
  const auto swapped = [](int rank, uint64_t frame) {
    SceneHeld scene = sceneOf(rank, frame);
    scene.swaps = frame;
    return scene;
  };
  Meetings meetings(0, 2);
  meetings.begin(swapped(0, 1), 0);
  meetings.holds(swapped(1, 1));
  EXPECT_EQ(meetings.stateOf(1, 0), State::here);
  meetings.end();
  meetings.holds(swapped(1, 2));
  meetings.begin(swapped(0, 3), 1);
  EXPECT_EQ(meetings.stateOf(1, 1.5), State::awaited);
  meetings.holds(swapped(1, 3));
  EXPECT_EQ(meetings.stateOf(1, 1.5), State::here);
}

/// The peer draws nothing of some views, and counts fewer frames. Both wait for the same image.
TEST(Meetings, RanksThatMissViewsMeetInTheNextOnes) {
  Meetings meetings(0, 2);
  uint64_t counted = 0;
  for (uint64_t frame = 1; frame < 9; ++frame) {
    const double now = static_cast<double>(2 * frame);
    meetings.begin(sceneOf(0, frame), now);
    if (frame % 3 == 0) {
      EXPECT_EQ(meetings.stateOf(1, now + 0.5), State::awaited);
      EXPECT_EQ(meetings.stateOf(1, now + 1.5), State::absent);
    } else {
      meetings.holds(sceneOf(1, ++counted));
      EXPECT_EQ(meetings.stateOf(1, now + 0.2), State::here) << frame;
      meetings.ends(1);
    }
    meetings.end();
  }
}

TEST(Meetings, PeersThatHaveTheirImageWaitForNobody) {
  Meetings meetings(0, 2);
  meetings.begin(sceneOf(0, 1), 0);
  meetings.holds(sceneOf(1, 1));
  EXPECT_EQ(meetings.stateOf(1, 0), State::here);
  meetings.end();
  meetings.holds(sceneOf(1, 2));
  meetings.ends(1);
  meetings.begin(sceneOf(0, 3), 1);
  EXPECT_EQ(meetings.stateOf(1, 1.5), State::awaited);
}

TEST(Meetings, PeersThatFailOrLeaveAreLeftOut) {
  Meetings meetings(0, 3);
  meetings.begin(sceneOf(0, 1), 0);
  meetings.holds(sceneOf(1, 1)), meetings.holds(sceneOf(2, 1));
  meetings.fail(1), meetings.leaves(2);
  EXPECT_EQ(meetings.stateOf(1, 0), State::absent);
  EXPECT_EQ(meetings.stateOf(2, 0), State::absent);
  EXPECT_FALSE(meetings.awaits(0));
  meetings.end();
  meetings.begin(sceneOf(0, 2), 1);
  EXPECT_FALSE(meetings.awaits(1));
  meetings.joins(2);
  EXPECT_TRUE(meetings.awaits(1));
}

}  // namespace
}  // namespace gluray::cluster
