#include "control/top_rows.h"

#include <gtest/gtest.h>

namespace gluray::launcher {
namespace {

using nlohmann::json;

RunningProgram program(int64_t ranks) {
  RunningProgram one;
  one.number = 1, one.pid = 4242, one.name = "paraview", one.ranks = ranks;
  return one;
}

json rank(int number, int images, double eye, double light, double depths, double sent) {
  return {{"rank", number},
          {"state", "connected"},
          {"host", "node" + std::to_string(number)},
          {"images", images},
          {"ms",
           {{"image", 100},
            {"eye", eye},
            {"light", light},
            {"waiting", {{"scenes", 0}, {"depths", depths}, {"answers", 1}}}}},
          {"bytes", {{"sent", sent}, {"received", 2 * sent}}},
          {"memory", 5e8}};
}

TEST(TopRows, ProgramsWithoutRanksHaveOne) {
  TopProgram one(program(1));
  EXPECT_TRUE(one.rows().empty());
  one.take({{"fps", 12.5}, {"memory", 2e8}, {"ranks", nullptr}}, 1);
  ASSERT_EQ(one.rows().size(), 1u);
  EXPECT_EQ(
      topTable({one}),
      "program          rank  host   fps  eye ms  light ms  waiting ms  sent MB/s  received MB/s  memory MB\n"
      "paraview (4242)     -        12.5       -         -           -          -              -        "
      "200\n");
}

TEST(TopRows, RatesAreThoseBetweenTwoStates) {
  TopProgram one(program(2));
  one.take({{"ranks", {rank(0, 10, 5, 50, 3, 1e6), rank(1, 10, 5, 50, 3, 1e6)}}}, 100);
  EXPECT_FALSE(one.hasRates());
  EXPECT_LT(one.rows()[0].fps, 0) << "not known yet";
  EXPECT_EQ(one.rows()[0].light, 50);
  // Ten more images, each with 150 ms of light.
  one.take({{"ranks", {rank(0, 20, 5, 100, 3, 5e6), rank(1, 10, 5, 50, 3, 1e6)}}}, 102);
  const std::vector<TopRow> rows = one.rows();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_DOUBLE_EQ(rows[0].fps, 5);
  EXPECT_DOUBLE_EQ(rows[0].light, 150);
  EXPECT_DOUBLE_EQ(rows[0].waiting, 4);
  EXPECT_DOUBLE_EQ(rows[0].sent, 2e6);
  EXPECT_DOUBLE_EQ(rows[0].received, 4e6);
  EXPECT_DOUBLE_EQ(rows[1].fps, 0);
  EXPECT_DOUBLE_EQ(rows[1].light, 50) << "of its last images";
  EXPECT_EQ(topJson({one})[0]["sentPerSecond"], 2e6);
}

TEST(TopRows, LostRanksAndWrongStates) {
  TopProgram one(program(3));
  json lost = rank(1, 3, 1, 1, 1, 1);
  lost["state"] = "lost";
  one.take({{"ranks", {{{"rank", 0}, {"state", "never connected"}}, lost, "no rank", {{"rank", -1}}}}}, 1);
  const std::vector<TopRow> rows = one.rows();
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].state, "never connected");
  EXPECT_LT(rows[0].memory, 0);
  EXPECT_EQ(rows[1].state, "lost");
  one.take("no state", 2);
  EXPECT_EQ(one.rows().size(), 2u);
  TopProgram other(program(4));
  other.take({{"fps", "no number"}, {"ranks", "no list"}}, 1);
  ASSERT_EQ(other.rows().size(), 1u);
  EXPECT_EQ(other.rows()[0].rank, 0);
  EXPECT_LT(other.rows()[0].fps, 0);
}

}  // namespace
}  // namespace gluray::launcher
