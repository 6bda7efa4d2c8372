#include "cluster/worker/rank_states.h"

#include <gtest/gtest.h>

namespace gluray::cluster {
namespace {

TEST(RankStates, ALateRankIsBackWhenItIsHeard) {
  RankStates states(2, 0, 1);
  EXPECT_EQ(states.setLate(1, 100), 0);
  EXPECT_TRUE(states.isLate(1));
  states.tick(200);
  EXPECT_TRUE(states.isLate(1)) << "nothing came from it";
  states.heard(1, 201);
  EXPECT_FALSE(states.isLate(1));
}

TEST(RankStates, RestsDoubleWhileARankIsLateAgainAndAgain) {
  RankStates states(2, 0, 1);
  double now = 100, rest = 0;
  EXPECT_EQ(states.setLate(1, now), 0);
  for (const double next : {2, 4, 8, 16, 32, 32}) {
    states.heard(1, now += rest + 0.5);
    EXPECT_FALSE(states.isLate(1));
    EXPECT_EQ(states.setLate(1, now += 1), next);
    rest = next;
  }
}

TEST(RankStates, ARankThatIsHeardRestsUntilItsTimeIsOver) {
  RankStates states(2, 0, 1);
  states.setLate(1, 100);
  states.heard(1, 101);
  EXPECT_EQ(states.setLate(1, 102), 2);
  states.heard(1, 102.1);
  EXPECT_TRUE(states.isLate(1));
  EXPECT_FALSE(states.tracers(false)[1].here);
  states.tick(103.9);
  EXPECT_TRUE(states.isLate(1));
  states.tick(104);
  EXPECT_FALSE(states.isLate(1));
}

TEST(RankStates, ARankThatWorkedForLongHasNoRest) {
  RankStates states(2, 0, 1);
  states.setLate(1, 100);
  states.heard(1, 101);
  EXPECT_EQ(states.setLate(1, 102), 2);
  states.heard(1, 105);
  EXPECT_EQ(states.setLate(1, 120), 0);
}

}  // namespace
}  // namespace gluray::cluster
