#include "tests/network/cables.h"

#include <gtest/gtest.h>

#include <utility>

namespace network {
namespace {

constexpr int64_t kUs = 1000, kMs = 1'000'000;  // ns

/// From and to addresses that end in these numbers.
Bytes frame(int from, int to, size_t size = 1000) {
  Bytes bytes(size, 0);
  bytes[5] = static_cast<uint8_t>(to), bytes[11] = static_cast<uint8_t>(from);
  return bytes;
}

/// Lets all cables' addresses be known: cable 0 has address 1, and so on.
void introduce(Cables& cables) {
  for (size_t i = 0; i < cables.count(); ++i) cables.sent(i, frame(static_cast<int>(i) + 1, 255), 0);
  cables.advance(0, [](size_t, const Bytes&) { return true; });
}

/// Where frames arrive until that time.
std::vector<size_t> arrivals(Cables& cables, int64_t until) {
  std::vector<size_t> found;
  cables.advance(until, [&](size_t to, const Bytes&) { return found.push_back(to), true; });
  return found;
}

using Places = std::vector<size_t>;

TEST(Cables, UnknownAddressesGoEverywhereAndKnownOnesToTheirCable) {
  Cables cables(3);
  cables.sent(0, frame(1, 2), 0);
  EXPECT_EQ(arrivals(cables, 0), (Places{1, 2}));
  cables.sent(1, frame(2, 1), 0);
  EXPECT_EQ(arrivals(cables, 0), Places{0});
  cables.sent(0, frame(1, 2), 0);
  EXPECT_EQ(arrivals(cables, 0), Places{1});
  EXPECT_EQ(cables.bytesText(), "0 2000 1000;1000 0 0;0 0 0");
}

TEST(Cables, DelaysOfBothCablesAddUp) {
  Cables cables(2);
  introduce(cables);
  cables.at(0).delayNs = 20 * kUs, cables.at(1).delayNs = 30 * kUs;
  cables.sent(0, frame(1, 2), 5 * kUs);
  EXPECT_EQ(arrivals(cables, 5 * kUs), Places{});
  EXPECT_EQ(cables.next(5 * kUs), 55 * kUs);
  EXPECT_EQ(arrivals(cables, 54 * kUs), Places{});
  EXPECT_EQ(arrivals(cables, 55 * kUs), Places{1});
  EXPECT_EQ(cables.next(55 * kUs), -1);
}

TEST(Cables, RatesSpaceFramesAndHoldSendersBack) {
  Cables cables(2);
  introduce(cables);
  cables.at(0).bitsPerSecond = 80e6;  // 100 us a frame of 1000 bytes
  for (int i = 0; i < 3; ++i) cables.sent(0, frame(1, 2), 0);
  EXPECT_EQ(arrivals(cables, 99 * kUs), Places{});
  EXPECT_EQ(arrivals(cables, 100 * kUs), Places{1});
  EXPECT_EQ(arrivals(cables, 300 * kUs), (Places{1, 1}));
  // A host has 64 KiB on their way at most, and the frame that passes this.
  int taken = 0;
  for (; cables.takesFrom(0, 300 * kUs); ++taken) cables.sent(0, frame(1, 2), 300 * kUs);
  EXPECT_EQ(taken, 66);
}

TEST(Cables, SlowReceiversLoseWhatTheSwitchCannotKeep) {
  Cables cables(2);
  introduce(cables);
  cables.at(1).bitsPerSecond = 8e6;  // 1 ms a frame
  for (int i = 0; i < 1000; ++i) cables.sent(0, frame(1, 2), 0);
  // 512 KiB wait, and one passes.
  EXPECT_EQ(arrivals(cables, 2000 * kMs).size(), 525u);
}

TEST(Cables, ShareOfFramesIsLost) {
  Cables cables(2);
  introduce(cables);
  cables.at(1).lostShare = 0.25;
  for (int i = 0; i < 10000; ++i) cables.sent(0, frame(1, 2), 0);
  EXPECT_NEAR(static_cast<double>(arrivals(cables, 0).size()), 7500, 150);
}

TEST(Cables, CutCablesAndPairs) {
  Cables cables(3);
  introduce(cables);
  cables.setCut(0, 1, true);
  cables.sent(0, frame(1, 2), 0), cables.sent(1, frame(2, 1), 0), cables.sent(0, frame(1, 3), 0);
  EXPECT_EQ(arrivals(cables, 0), Places{2});
  cables.setCut(0, 1, false), cables.setCut(2, 2, true);
  cables.sent(0, frame(1, 2), 0), cables.sent(0, frame(1, 3), 0), cables.sent(2, frame(3, 1), 0);
  EXPECT_EQ(arrivals(cables, 0), Places{1});
}

TEST(Cables, WhatIsUnderwayWhenACableIsCutIsLost) {
  Cables cables(2);
  introduce(cables);
  cables.at(0).delayNs = kMs;
  cables.sent(0, frame(1, 2), 0);
  cables.setCut(0, 0, true);
  EXPECT_EQ(arrivals(cables, kMs), Places{});
  cables.setCut(0, 0, false);
  cables.sent(0, frame(1, 2), kMs);
  EXPECT_EQ(arrivals(cables, 2 * kMs), Places{1});
}

}  // namespace
}  // namespace network
