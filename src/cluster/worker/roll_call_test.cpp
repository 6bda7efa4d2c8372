#include "cluster/worker/roll_call.h"

#include "cluster/messages/rank_messages.h"
#include "cluster/messages/version.h"
#include "cluster/testing/job_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace gluray::cluster {
namespace {

using Bytes = std::vector<std::byte>;

class RollCallTest : public testing::Test {
 protected:
  RollCall& rankZero() {
    if (!roll_) roll_.emplace(head_, "1.0 (2)", [this](const std::string& line) { said_ += line + "\n"; });
    return *roll_;
  }
  /// Why rank 1 is refused when it says this; empty: it is not.
  std::string refusal(const Bytes& hello) {
    try {
      rankZero().takeHello(1, hello);
    } catch (const RanksFailed& why) { return why.what(); }
    return "";
  }
  static Bytes hello(const std::string& version) {
    return encoded(RankHello{RankHello::kOrder, version, "node1"});
  }

  std::shared_ptr<test::ThreadJob> job_ = std::make_shared<test::ThreadJob>(2);
  test::ThreadRanks head_{job_, 0}, other_{job_, 1};
  std::optional<RollCall> roll_;
  std::string said_;
};

TEST_F(RollCallTest, IsOverWhenAllHaveTheVersion) {
  EXPECT_EQ(refusal(hello("1.0 (2)")), "");
  EXPECT_FALSE(other_.receive()) << "rank 0 has said nothing yet";
  rankZero().takeHello(0, hello("1.0 (2)"));
  const auto message = other_.receive();
  ASSERT_TRUE(message);
  EXPECT_EQ(message->bytes, forRanks(AllAreAlike{}));
  EXPECT_FALSE(rankZero().isOver());
  rankZero().takeEnd();
  EXPECT_TRUE(rankZero().isOver());
}

TEST_F(RollCallTest, OtherVersionsAreNamed) {
  const std::string why = refusal(hello("0.9 (7)"));
  EXPECT_EQ(why.find("rank 1 is of GLuRay 0.9 (7) on node1, rank 0 of GLuRay 1.0 (2)"), 0u) << why;
  EXPECT_NE(why.find("use one version on all hosts"), std::string::npos) << why;
}

TEST_F(RollCallTest, LaterVersionsMaySayMore) {
  Bytes longer = hello("1.1 (1)");
  longer.resize(longer.size() + 5);
  EXPECT_NE(refusal(longer).find("GLuRay 1.1 (1) on node1"), std::string::npos);
}

TEST_F(RollCallTest, AnotherByteOrder) {
  Bytes swapped = hello("1.0 (2)");
  std::reverse(swapped.begin(), swapped.begin() + sizeof(uint32_t));
  EXPECT_NE(refusal(swapped).find("another byte order"), std::string::npos);
  EXPECT_EQ(RankHello::kType >> 8, RankHello::kType & 0xFF) << "it is known in both";
}

TEST_F(RollCallTest, WhateverElseComesIsOfAnotherVersion) {
  for (size_t size = 0; size < 20; ++size)
    EXPECT_NE(refusal(Bytes(size, std::byte{0x55})).find("unknown version"), std::string::npos) << size;
}

TEST_F(RollCallTest, SilentRanksAreNamedOnce) {
  rankZero().takeHello(0, hello("1.0 (2)"));
  for (const double now : {100.0, 109.0}) rankZero().tick(now);
  EXPECT_EQ(said_, "");
  for (const double now : {111.0, 120.0, 140.0}) rankZero().tick(now);
  EXPECT_NE(said_.find("which version they are of: 1\n"), std::string::npos) << said_;
  EXPECT_EQ(std::ranges::count(said_, '\n'), 1);
}

TEST_F(RollCallTest, AProcessAloneHasNobodyToAsk) {
  test::ThreadRanks alone(std::make_shared<test::ThreadJob>(1), 0);
  EXPECT_TRUE(RollCall(alone, "1.0 (2)", nullptr).isOver());
}

TEST_F(RollCallTest, AJobOfTwoVersionsEnds) {
  Worker worker(head_, 1, SIZE_MAX, Descriptor(), [](const std::string&) {});
  std::atomic<bool> stop{false};
  other_.send(0, forRanks(RankHello{RankHello::kOrder, "0.9 (7)", "node1"}));
  EXPECT_THROW(worker.meet(stop), RanksFailed);
}

TEST_F(RollCallTest, ProgramsComeWhenAllRanksAreKnown) {
  Worker worker(head_, 1, SIZE_MAX, Descriptor(), [](const std::string&) {});
  std::atomic<bool> stop{false}, over{false};
  std::thread thread([&] {
    worker.meet(stop);
    over = true;
  });
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_FALSE(over);
  other_.send(0, forRanks(RankHello{RankHello::kOrder, version(), "node1"}));
  thread.join();
  EXPECT_TRUE(over);
}

}  // namespace
}  // namespace gluray::cluster
