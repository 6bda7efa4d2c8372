#include "cluster/gather/part_meetings.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::cluster {
namespace {

constexpr Hash128 kData{1, 1};

/// A part that lies `x` from the axis, seen from `camera` from the axis.
PartHere partHere(int rank, double x = 0, double camera = 0, int width = 100) {
  PartHere part;
  part.address.from = rank;
  part.view.frame = 1;
  part.view.viewport = {0, 0, width, 100};
  part.view.clipFromEye = glm::perspective(1.0, 1.0, 0.1, 100.0);
  part.view.eyeFromWorld = glm::translate(glm::dmat4(1), glm::dvec3(-camera, 0, -10));
  part.view.lower = glm::dvec3(x - camera - 0.5, -0.5, -10.5);
  part.view.upper = glm::dvec3(x - camera + 0.5, 0.5, -9.5);
  return part;
}

/// Rank 0, and one peer.
struct PartMeetingsTest : testing::Test {
  using State = PartMeetings::State;
  /// A scene that both ranks draw.
  void bothDraw(double x, double camera, uint64_t view = 1) {
    meetings.begin({partHere(0, 0, camera), view, kData}, now);
    meetings.opens(partHere(1, x, camera));
    EXPECT_EQ(meetings.stateOf(1, now), State::here);
    end();
  }
  /// For how long a scene waits that this rank alone draws.
  enum class Waits { no, little, long_ };
  Waits aloneDraws(double camera, uint64_t view = 1, Hash128 data = kData, bool moving = false) {
    meetings.begin({partHere(0, 0, camera), view, data, moving}, now);
    if (!meetings.awaits(now)) return end(), Waits::no;
    const bool isLong = meetings.awaits(now + 0.9);
    EXPECT_EQ(meetings.stateOf(1, now += 2), State::absent);
    return end(), isLong ? Waits::long_ : Waits::little;
  }
  void end() { meetings.closes(1), now += 1; }
  PartMeetings meetings{0, 2};
  double now = 0;
};

TEST_F(PartMeetingsTest, PeersThatWaitWithTheSameViewMeet) {
  meetings.begin({partHere(0), 1, kData}, now);
  EXPECT_EQ(meetings.stateOf(1, now), State::awaited);
  EXPECT_TRUE(meetings.here(now).empty());
  meetings.opens(partHere(1, 0, 0, 30));
  EXPECT_EQ(meetings.stateOf(1, now), State::awaited) << "another viewport";
  meetings.opens(partHere(1));
  EXPECT_EQ(meetings.here(now), std::vector<int>{1});
  EXPECT_TRUE(meetings.hasOurEyeSpace(1));
  meetings.closes(1);
  EXPECT_EQ(meetings.stateOf(1, now), State::absent) << "it was here, and is not awaited again";
}

TEST_F(PartMeetingsTest, ScenesThatAreOverAreNotMet) {
  bothDraw(0, 0);
  meetings.begin({partHere(0), 1, kData}, now);
  EXPECT_EQ(meetings.stateOf(1, now), State::awaited);
}

TEST_F(PartMeetingsTest, PeersThatDrawNothingAreAwaitedOnce) {
  EXPECT_EQ(Waits::long_, aloneDraws(0));
  EXPECT_EQ(meetings.newlyLate(), std::vector<int>{1});
  EXPECT_TRUE(meetings.newlyLate().empty());
  EXPECT_EQ(Waits::little, aloneDraws(0));
  EXPECT_EQ(Waits::little, aloneDraws(1));
  EXPECT_EQ(Waits::little, aloneDraws(0, 2)) << "nor in another view";
  EXPECT_EQ(Waits::no, aloneDraws(0, 2, kData, true)) << "frames of animations";
  bothDraw(0, 0);
  EXPECT_EQ(Waits::long_, aloneDraws(0));
}

TEST_F(PartMeetingsTest, PeersAreAwaitedWhenTheirDataComeIntoView) {
  bothDraw(3, 0);
  EXPECT_EQ(Waits::long_, aloneDraws(-20)) << "it may draw what lies outside";
  EXPECT_EQ(Waits::no, aloneDraws(-21));
  EXPECT_EQ(Waits::long_, aloneDraws(2)) << "visible again";
  EXPECT_EQ(Waits::little, aloneDraws(1)) << "but it draws nothing any more";
  bothDraw(3, 1);
  EXPECT_EQ(Waits::no, aloneDraws(-20)) << "it is known by now to draw nothing there";
  EXPECT_EQ(Waits::long_, aloneDraws(1));
}

TEST_F(PartMeetingsTest, PeersThatDrawWhatLiesOutsideAreAwaitedThere) {
  bothDraw(3, 0);
  bothDraw(3, -20);
  EXPECT_EQ(Waits::long_, aloneDraws(-20));
}

TEST_F(PartMeetingsTest, ViewsAreApart) {
  bothDraw(0, 0, 1);
  EXPECT_EQ(Waits::long_, aloneDraws(0, 2));
  for (int frame = 0; frame < 3; ++frame) {
    bothDraw(0, 0, 1);
    EXPECT_EQ(Waits::little, aloneDraws(0, 2)) << "it hides the data in that view";
  }
}

TEST_F(PartMeetingsTest, PeersMayDrawAgainWhenDataChange) {
  bothDraw(0, 0);
  int waits = 0;
  for (uint64_t data = 2; data < 102; ++data) waits += aloneDraws(0, 1, {data, 1}) == Waits::long_;
  EXPECT_GE(waits, 4);
  EXPECT_LE(waits, 7) << "ever less often";
  bothDraw(0, 0);
  EXPECT_EQ(Waits::long_, aloneDraws(0, 1, {1, 1}));
}

TEST_F(PartMeetingsTest, PeersThatSendGeometryAreAwaitedLonger) {
  meetings.begin({partHere(0), 1, kData}, 0);
  for (double time = 0; time < 5; time += 0.2) {
    meetings.comes(1, time);
    EXPECT_EQ(meetings.stateOf(1, time), State::awaited);
  }
  EXPECT_EQ(meetings.stateOf(1, 7), State::absent);
}

/// A program whose ranks do not wait for each other, and swap.
TEST_F(PartMeetingsTest, CountsOfFramesTellFramesOfOneViewApart) {
  const auto part = [](int rank, uint64_t frame) {
    PartHere made = partHere(rank);
    made.view.frame = frame;
    return made;
  };
  for (uint64_t frame = 1; frame < 6; ++frame) {
    meetings.begin({part(0, frame), 1, kData}, now);
    meetings.opens(part(1, frame + 7));
    EXPECT_EQ(meetings.stateOf(1, now), State::here) << "counts differ by a constant";
    end();
  }
  meetings.begin({part(0, 6), 1, kData}, now);
  meetings.opens(part(1, 12));
  EXPECT_EQ(meetings.stateOf(1, now), State::awaited) << "it is at the frame before";
  meetings.opens(part(1, 14));
  EXPECT_EQ(meetings.stateOf(1, now), State::absent) << "it is at the frame after";
  end();
  meetings.begin({part(0, 7), 1, kData}, now);
  meetings.opens(part(1, 20));
  EXPECT_EQ(meetings.stateOf(1, now), State::here) << "these counts tell nothing";
}

TEST_F(PartMeetingsTest, PeersThatFailOrLeaveAreLeftOut) {
  meetings.begin({partHere(0), 1, kData}, now);
  meetings.opens(partHere(1));
  meetings.fail(1);
  EXPECT_EQ(meetings.stateOf(1, now + 2), State::absent);
  meetings.leaves(1);
  meetings.begin({partHere(0), 1, kData}, now);
  EXPECT_FALSE(meetings.awaits(now));
  meetings.joins(1);
  meetings.begin({partHere(0), 1, kData}, now);
  EXPECT_TRUE(meetings.awaits(now));
}

}  // namespace
}  // namespace gluray::cluster
