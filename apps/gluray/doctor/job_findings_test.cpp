// The findings of `gluray doctor --job` for made-up facts.
#include "doctor/job_findings.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gluray::launcher {
namespace {

constexpr uint64_t kGigabyte = uint64_t{1} << 30;

/// A rank alone on a host of its own without a fault.
cluster::RankFacts rankOf(int number) {
  cluster::RankFacts rank;
  rank.rank = number, rank.answered = true;
  rank.version = "1.0 (2)", rank.mpi = "Open MPI 4.1.4", rank.host = "node" + std::to_string(number);
  rank.threads = rank.usableCores = rank.hostCores = 8, rank.cores = "0-7";
  rank.memoryBytes = 32 * kGigabyte, rank.availableBytes = 30 * kGigabyte;
  rank.shmBytes = 16 * kGigabyte, rank.shmFreeBytes = 16 * kGigabyte;
  rank.hugePages = "madvise";
  return rank;
}

class JobFindings : public testing::Test {
 protected:
  JobFindings() : facts({{rankOf(0), rankOf(1), rankOf(2)}}) {}
  /// All ranks on one host.
  void moveTogether(int threads) {
    for (cluster::RankFacts& rank : facts.ranks)
      rank.host = "node", rank.rankHere = rank.rank, rank.ranksHere = 3, rank.threads = threads;
  }
  Diagnosis judged() const {
    Diagnosis diagnosis;
    judgeJob("evening", facts, diagnosis);
    return diagnosis;
  }
  /// The only finding that is not ok.
  Finding fault() const {
    Diagnosis diagnosis = judged();
    std::vector<Finding> faults;
    for (const Finding& finding : diagnosis.findings())
      if (finding.health != Health::ok) faults.push_back(finding);
    EXPECT_EQ(faults.size(), 1u) << diagnosis.text();
    return faults.empty() ? Finding{} : faults[0];
  }
  cluster::JobFacts facts;
};

TEST_F(JobFindings, AJobWithoutFaults) {
  const Diagnosis diagnosis = judged();
  ASSERT_EQ(diagnosis.findings().size(), 4u);
  EXPECT_EQ(diagnosis.exitCode(), 0);
  EXPECT_EQ(diagnosis.findings()[0].text,
            "\"evening\" answers: 3 ranks on 3 hosts, 24 threads, Open MPI 4.1.4, GLuRay 1.0 (2) as this "
            "program, little-endian");
  EXPECT_EQ(diagnosis.findings()[2].topic, "rank 1");
  EXPECT_EQ(diagnosis.findings()[2].text,
            "node1: 8 threads on all 8 cores; 32.0 GB of memory, 30.0 GB of it available; /dev/shm 16.0 GB "
            "free; huge pages: madvise");
}

TEST_F(JobFindings, RanksThatDoNotAnswerAreNamed) {
  facts.ranks[1] = facts.ranks[2] = {};
  facts.ranks[1].rank = 1, facts.ranks[2].rank = 2;
  const Finding found = fault();
  EXPECT_EQ(found.health, Health::limited);
  EXPECT_TRUE(found.text.starts_with("ranks 1, 2 have not answered within 2 seconds")) << found.text;
}

TEST_F(JobFindings, OtherVersionsAreRefused) {
  facts.ranks[1] = {};
  facts.ranks[1].rank = 1, facts.ranks[1].answered = true, facts.ranks[1].version = "1.1 (1)";
  const Finding found = fault();
  EXPECT_EQ(found.health, Health::broken);
  EXPECT_EQ(found.text,
            "the ranks are of different versions: GLuRay 1.0 (2): ranks 0, 2; GLuRay 1.1 (1): rank 1");
}

TEST_F(JobFindings, OtherVersionsOfMpi) {
  facts.ranks[2].mpi = "Open MPI 5.0.7";
  EXPECT_EQ(fault().topic, "MPI");
}

TEST_F(JobFindings, RanksBoundToOneCore) {
  for (const size_t rank : {0u, 1u}) {
    facts.ranks[rank].host = "node", facts.ranks[rank].usableCores = facts.ranks[rank].threads = 1;
    facts.ranks[rank].cores = std::to_string(rank);
  }
  const Finding found = fault();
  EXPECT_EQ(found.text, "ranks 0, 1 on node are each bound to one of 8 cores");
  EXPECT_NE(found.fix.find("--bind-to none"), std::string::npos) << found.fix;
  facts.ranks[0].hostCores = facts.ranks[1].hostCores = 1;
  facts.ranks[1].host = "other";
  EXPECT_EQ(judged().exitCode(), 0) << "hosts of one core";
}

TEST_F(JobFindings, MoreThreadsThanCores) {
  moveTogether(2);
  EXPECT_EQ(judged().exitCode(), 0);
  moveTogether(3);
  const Finding found = fault();
  EXPECT_EQ(found.text, "ranks 0-2 on node together trace with 9 threads on 8 cores");
  EXPECT_TRUE(found.fix.starts_with("gluray-worker --threads 2")) << found.fix;
}

TEST_F(JobFindings, RanksThatAreBoundToTheSameCores) {
  moveTogether(2);
  for (const size_t rank : {0u, 2u}) facts.ranks[rank].usableCores = 2, facts.ranks[rank].cores = "0-1";
  EXPECT_EQ(fault().text, "ranks 0, 2 on node together trace with 4 threads on 2 cores");
}

TEST_F(JobFindings, FullSharedMemory) {
  facts.ranks[2].shmFreeBytes = kGigabyte;
  EXPECT_TRUE(fault().text.starts_with("node2: 1024 MB free of 16384 MB"));
  facts.ranks[2].shmBytes = facts.ranks[2].shmFreeBytes = 0;
  EXPECT_EQ(judged().exitCode(), 0) << "there is none";
}

TEST_F(JobFindings, LessMemoryThanOnOtherHosts) {
  facts.ranks[1].availableBytes = 14 * kGigabyte;
  EXPECT_TRUE(fault().text.starts_with("node1 has 14.0 GB of memory available, 14.0 GB for each rank"));
  facts.ranks[1].availableBytes = 3 * kGigabyte;
  EXPECT_EQ(fault().text, "node1 has 3.0 GB of memory available of 32.0 GB");
}

TEST_F(JobFindings, NamesOfRanks) {
  EXPECT_EQ(ranksText({3}), "rank 3");
  EXPECT_EQ(ranksText({0, 1, 2, 5, 7, 8}), "ranks 0-2, 5, 7, 8");
}

}  // namespace
}  // namespace gluray::launcher
