#include "cluster/worker/facts/rank_facts.h"

#include "cluster/messages/version.h"
#include "cluster/ranks/alone.h"

#include <gtest/gtest.h>

namespace gluray::cluster {
namespace {

TEST(RankFacts, LinesOfFiles) {
  const std::string text =
      "MemTotal:       64 kB\nMemAvailableX:  1 kB\nMemAvailable:\t32 kB\nEmpty:\nLast: 0-3,8";
  EXPECT_EQ(lineOf(text, "MemTotal"), "64 kB");
  EXPECT_EQ(lineOf(text, "MemAvailable"), "32 kB");
  EXPECT_EQ(lineOf(text, "Empty"), "");
  EXPECT_EQ(lineOf(text, "Last"), "0-3,8");
  EXPECT_EQ(lineOf(text, "Mem"), "");
  EXPECT_EQ(lineOf("", "Mem"), "");
}

TEST(RankFacts, Memory) {
  EXPECT_EQ(memoryOf("64 kB"), 65536u);
  for (const char* wrong :
       {"", "kB", "64", "64 MB", "-1 kB", "99999999999999999999 kB", "9000000000000000000 kB"})
    EXPECT_EQ(memoryOf(wrong), 0u) << wrong;
}

TEST(RankFacts, Cores) {
  EXPECT_EQ(countCores("0"), 1);
  EXPECT_EQ(countCores("0-3,8"), 5);
  EXPECT_EQ(countCores("2-2,4-5,1023"), 4);
  for (const char* wrong : {"", "-", "3-", "3-1", "1,", ",1", "a", "1;2", "0-99999999999", "0 "})
    EXPECT_EQ(countCores(wrong), 0) << wrong;
}

TEST(RankFacts, ChosenWords) {
  EXPECT_EQ(chosenWord("always [madvise] never\n"), "madvise");
  EXPECT_EQ(chosenWord("[always] madvise never\n"), "always");
  for (const char* wrong : {"", "always", "always [", "] [a"}) EXPECT_EQ(chosenWord(wrong), "") << wrong;
}

TEST(RankFacts, OfThisProcess) {
  const Alone ranks;
  const RankFacts facts = factsOf(ranks, 3);
  EXPECT_EQ(facts.threads, 3);
  EXPECT_EQ(facts.version, version());
  EXPECT_EQ(facts.mpi, "no MPI");
  EXPECT_FALSE(facts.host.empty());
  EXPECT_FALSE(facts.answered);
  EXPECT_GE(facts.usableCores, 1);
  EXPECT_GE(facts.hostCores, facts.usableCores);
  EXPECT_GT(facts.memoryBytes, facts.availableBytes);
  EXPECT_GT(facts.availableBytes, 0u);
  EXPECT_FALSE(facts.isBigEndian);
}

}  // namespace
}  // namespace gluray::cluster
