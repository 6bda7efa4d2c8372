#include "cluster/shares/tile_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

namespace gluray::cluster {
namespace {

/// Ranks that trace what they get, each at its own speed; returns how often each tile was traced.
struct Simulation {
  TileShares shares;
  std::vector<float> costs, perUnit;  // perUnit: seconds for a unit of cost, by rank
  std::vector<double> clock;
  std::map<int, int> traced;
  std::vector<std::vector<int>> queues;

  Simulation(std::vector<float> tiles, std::vector<float> slowness, const std::vector<Tracer>& tracers)
      : shares(tiles, nullptr, tracers),
        costs(std::move(tiles)),
        perUnit(std::move(slowness)),
        clock(perUnit.size()),
        queues(perUnit.size()) {}

  void fill() {
    for (size_t r = 0; r < queues.size(); ++r) {
      const std::vector<int> more = shares.more(static_cast<int>(r));
      queues[r].insert(queues[r].end(), more.begin(), more.end());
    }
  }
  /// The rank that is done first traces its next tile.
  bool step() {
    fill();
    int first = -1;
    for (size_t r = 0; r < queues.size(); ++r)
      if (!queues[r].empty() && (first < 0 || clock[r] < clock[static_cast<size_t>(first)]))
        first = static_cast<int>(r);
    if (first < 0) return false;
    const auto r = static_cast<size_t>(first);
    const int tile = queues[r].front();
    queues[r].erase(queues[r].begin());
    clock[r] += static_cast<double>(costs[static_cast<size_t>(tile)] * perUnit[r]);
    ++traced[tile];
    EXPECT_TRUE(shares.finish(tile));
    return true;
  }
  void run() {
    while (step()) {}
  }
};

std::vector<float> uneven(size_t tiles) {
  std::vector<float> costs(tiles);
  for (size_t i = 0; i < tiles; ++i) costs[i] = i % 7 == 0 ? 20.0f : 1.0f + static_cast<float>(i % 5);
  return costs;
}

TEST(TileShares, EachTileIsTracedOnce) {
  Simulation all(uneven(1024), {1, 1, 1, 1}, std::vector<Tracer>(4));
  all.run();
  EXPECT_TRUE(all.shares.done());
  EXPECT_EQ(all.traced.size(), 1024u);
}

TEST(TileShares, RanksAreDoneTogetherThoughCostsAreUneven) {
  Simulation all(uneven(1024), {1, 1, 1, 1}, std::vector<Tracer>(4));
  all.run();
  const auto [first, last] = std::minmax_element(all.clock.begin(), all.clock.end());
  EXPECT_LT(*last - *first, 0.03 * *last);
}

TEST(TileShares, WhoIsSlowerThanThoughtLosesTilesToOthers) {
  Simulation all(std::vector<float>(1024, 1), {1, 4, 1, 1}, std::vector<Tracer>(4));
  all.run();
  const auto [first, last] = std::minmax_element(all.clock.begin(), all.clock.end());
  EXPECT_LT(*last - *first, 0.15 * *last);
  EXPECT_TRUE(all.shares.done());
}

TEST(TileShares, SharesAreNeighbours) {
  TileShares shares(std::vector<float>(100, 1), nullptr, std::vector<Tracer>(2));
  EXPECT_EQ(shares.more(0).front(), 0);
  EXPECT_EQ(shares.more(1).front(), 50);
}

TEST(TileShares, ThreadsAndSpeedCount) {
  TileShares shares(std::vector<float>(100, 1), nullptr, {{3, 1, true}, {1, 1, true}});
  EXPECT_EQ(shares.more(1).front(), 75);
  TileShares faster(std::vector<float>(100, 1), nullptr, {{1, 4, true}, {1, 1, true}});
  EXPECT_EQ(faster.more(1).front(), 80);
}

TEST(TileShares, OnlyWantedTilesAreTraced) {
  std::vector<unsigned char> wanted(64, 0);
  wanted[5] = wanted[60] = 1;
  TileShares shares(std::vector<float>(64, 1), &wanted, std::vector<Tracer>(2));
  std::set<int> got;
  for (const int rank : {0, 1})
    for (const int tile : shares.more(rank)) got.insert(tile);
  EXPECT_EQ(got, (std::set<int>{5, 60}));
  EXPECT_FALSE(shares.finish(6));
  EXPECT_TRUE(shares.finish(5));
  EXPECT_TRUE(shares.finish(60));
  EXPECT_TRUE(shares.done());
}

TEST(TileShares, TilesOfAGoneRankAreTracedByOthers) {
  Simulation all(std::vector<float>(200, 1), {1, 1, 1}, std::vector<Tracer>(3));
  for (int i = 0; i < 30; ++i) all.step();
  all.shares.drop(1);
  all.queues[1].clear();
  all.run();
  EXPECT_TRUE(all.shares.done());
  EXPECT_EQ(all.traced.size(), 200u);
}

TEST(TileShares, WhatAGoneRankHasTracedAllTheSameCounts) {
  TileShares shares(std::vector<float>(8, 1), nullptr, std::vector<Tracer>(2));
  const std::vector<int> slow = shares.more(1);
  ASSERT_FALSE(slow.empty());
  shares.drop(1);
  for (const int tile : slow) EXPECT_TRUE(shares.finish(tile));
  EXPECT_FALSE(shares.finish(slow[0])) << "once";
  for (std::vector<int> tiles; !(tiles = shares.more(0)).empty();)
    for (const int tile : tiles) EXPECT_TRUE(shares.finish(tile)) << tile;
  EXPECT_TRUE(shares.done());
}

TEST(TileShares, ASlowRankDoesNotTakeItsTilesBack) {
  TileShares shares(std::vector<float>(8, 1), nullptr, std::vector<Tracer>(2));
  const std::vector<int> slow = shares.more(0);
  for (std::vector<int> tiles; !(tiles = shares.more(1)).empty();)
    for (const int tile : tiles) shares.finish(tile);
  shares.giveBack(0);
  EXPECT_TRUE(shares.more(0).empty());
  EXPECT_TRUE(shares.isIdle(1));
  EXPECT_FALSE(shares.isIdle(0));
  std::vector<int> again = shares.more(1);
  std::ranges::sort(again);
  EXPECT_EQ(again, slow);
  EXPECT_TRUE(shares.finish(slow[0]));
  shares.resume(0);
  EXPECT_TRUE(shares.isIdle(0));
}

TEST(TileShares, NobodyIsLeft) {
  TileShares shares(std::vector<float>(8, 1), nullptr, std::vector<Tracer>(1));
  shares.drop(0);
  EXPECT_TRUE(shares.more(0).empty());
  EXPECT_FALSE(shares.done());
}

TEST(TileShares, RanksThatAreNotHereGetNothing) {
  TileShares shares(std::vector<float>(8, 1), nullptr, {{1, 1, false}, {1, 1, true}});
  EXPECT_TRUE(shares.more(0).empty());
  size_t count = 0;
  for (std::vector<int> tiles; !(tiles = shares.more(1)).empty(); count += tiles.size())
    for (const int tile : tiles) shares.finish(tile);
  EXPECT_EQ(count, 8u);
}

}  // namespace
}  // namespace gluray::cluster
