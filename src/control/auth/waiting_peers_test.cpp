#include "control/auth/waiting_peers.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::control {
namespace {

constexpr size_t kMax = WaitingPeers::kMax, kMaxPerNetwork = WaitingPeers::kMaxPerNetwork;

/// Adds a connection as the hub does. Returns the number of the connection that was closed; 0 if none.
uint64_t admit(WaitingPeers& waiting, const std::string& address) {
  const auto closed = waiting.toClose(address);
  if (closed) waiting.leave(*closed);
  waiting.join(address);
  return closed.value_or(0);
}

TEST(NetworkOf, IsWhatOneMachineMayChooseFrom) {
  EXPECT_EQ(networkOf("192.0.2.7"), "192.0.2.7");
  EXPECT_EQ(networkOf("::ffff:192.0.2.7"), "192.0.2.7");
  EXPECT_EQ(networkOf("2001:db8:1:2:3:4:5:6"), "2001:db8:1:2::/64");
  EXPECT_EQ(networkOf("2001:db8:1:2::"), networkOf("2001:db8:1:2:ffff::1"));
  EXPECT_NE(networkOf("2001:db8:1:2::1"), networkOf("2001:db8:1:3::1"));
  EXPECT_EQ(networkOf("fe80::1%eth0"), "fe80::/64");
  EXPECT_EQ(networkOf("::1"), "::/64");
  for (const char* other : {"", "?", "host", "1.2.3"}) EXPECT_EQ(networkOf(other), other);
}

TEST(WaitingPeers, AnAddressThatOpensManyLosesItsOldest) {
  WaitingPeers waiting;
  for (size_t i = 0; i < kMaxPerNetwork; ++i) EXPECT_EQ(admit(waiting, "192.0.2.1"), 0u);
  EXPECT_EQ(admit(waiting, "192.0.2.2"), 0u) << "another address has room";
  for (uint64_t i = 1; i <= 3 * kMaxPerNetwork; ++i)
    EXPECT_EQ(admit(waiting, "::ffff:192.0.2.1"), i <= kMaxPerNetwork ? i : i + 1);
  EXPECT_EQ(waiting.size(), kMaxPerNetwork + 1);
}

TEST(WaitingPeers, ThoseOfOneNetworkCountTogether) {
  WaitingPeers waiting;
  uint64_t closed = 0;
  for (size_t i = 0; i < 1000; ++i) closed += admit(waiting, "2001:db8::" + std::to_string(i)) != 0;
  EXPECT_EQ(closed, 1000 - kMaxPerNetwork);
  EXPECT_EQ(admit(waiting, "2001:db8:0:1::1"), 0u);
}

TEST(WaitingPeers, WhereAllPlacesAreTakenTheNetworkThatHoldsMostLosesOne) {
  WaitingPeers waiting;
  admit(waiting, "192.0.2.250");
  for (size_t i = 0; i < 41; ++i) admit(waiting, "192.0.2.251");
  for (size_t i = 0; waiting.size() < kMax; ++i) admit(waiting, "10.0.0." + std::to_string(i / 39));
  for (uint64_t next = 2; next <= 3; ++next)
    EXPECT_EQ(admit(waiting, "172.16.0." + std::to_string(next)), next);
  EXPECT_EQ(waiting.size(), kMax);
}

TEST(WaitingPeers, ThoseThatHaveLeftDoNotCount) {
  WaitingPeers waiting;
  EXPECT_FALSE(waiting.leastDeserving());
  std::vector<uint64_t> numbers;
  for (size_t i = 0; i < kMaxPerNetwork; ++i) numbers.push_back(waiting.join("192.0.2.1"));
  waiting.leave(numbers[3]), waiting.leave(numbers[3]), waiting.leave(12345);
  EXPECT_FALSE(waiting.toClose("192.0.2.1"));
  waiting.join("192.0.2.1");
  EXPECT_EQ(waiting.toClose("192.0.2.1"), numbers[0]);
  waiting.leave(numbers[0]);
  for (const uint64_t number : numbers) waiting.leave(number);
  EXPECT_EQ(waiting.size(), 1u);
}

}  // namespace
}  // namespace gluray::control
