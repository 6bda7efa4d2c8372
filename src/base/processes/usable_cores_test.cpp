#include "base/processes/usable_cores.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

namespace gluray {
namespace {

namespace fs = std::filesystem;

/// A machine of eight cores whose files and variables the test writes.
class UsableCores : public testing::Test {
 protected:
  UsableCores() {
    char folder[] = "/tmp/gluray-cores-XXXXXX";
    here_.root = mkdtemp(folder);
    here_.hostCores = here_.affinity = 8;
    here_.variable = [this](const char* name) { return variables_[name]; };
  }
  ~UsableCores() override { fs::remove_all(here_.root); }

  void write(const std::string& path, const std::string& text) {
    const fs::path file = here_.root + path;
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text << "\n";
  }
  ThreadCount chosen(int wanted = 0) { return chosenThreads(wanted, here_); }

  Surroundings here_;
  std::map<std::string, std::string> variables_;
};

TEST_F(UsableCores, AllWithoutLimits) {
  EXPECT_EQ(coresOfQuota(here_), 0) << "no files at all";
  EXPECT_EQ(chosen().threads, 8);
  EXPECT_EQ(chosen().because, "all cores");
  EXPECT_EQ(chosen(3).threads, 3);
  EXPECT_EQ(chosen(3).because, "setting threads");
  EXPECT_EQ(chosen(100).threads, 8) << "more would not run at the same time";
  EXPECT_EQ(chosen(100).because, "all cores");
}

TEST_F(UsableCores, QuotaOfVersion2) {
  write("/proc/self/cgroup", "0::/user.slice/job");
  write("/sys/fs/cgroup/user.slice/job/cpu.max", "max 100000");
  EXPECT_EQ(chosen().threads, 8);
  write("/sys/fs/cgroup/user.slice/job/cpu.max", "250000 100000");
  EXPECT_DOUBLE_EQ(coresOfQuota(here_), 2.5);
  EXPECT_EQ(chosen().threads, 3) << "rounded up";
  EXPECT_EQ(chosen().because, "CPU quota of the cgroup: 2.5 cores");
  EXPECT_EQ(chosen(2).threads, 2);
  EXPECT_EQ(chosen(6).threads, 3) << "the quota bounds the setting";
}

TEST_F(UsableCores, TheLeastQuotaOfAllLevelsCounts) {
  write("/proc/self/cgroup", "0::/a/b/c");
  write("/sys/fs/cgroup/a/cpu.max", "200000 100000");
  write("/sys/fs/cgroup/a/b/c/cpu.max", "400000 100000");
  EXPECT_DOUBLE_EQ(coresOfQuota(here_), 2);
}

TEST_F(UsableCores, QuotaOfAContainerWithItsOwnNamespace) {
  write("/proc/self/cgroup", "0::/");
  write("/sys/fs/cgroup/cpu.max", "100000 100000");
  EXPECT_EQ(chosen().threads, 1);
  EXPECT_EQ(chosen().because, "CPU quota of the cgroup: 1 core");
}

TEST_F(UsableCores, QuotaOfVersion1) {
  write("/proc/self/cgroup", "5:memory:/x\n4:cpu,cpuacct:/docker/77\n0::/system.slice");
  write("/sys/fs/cgroup/cpu,cpuacct/docker/77/cpu.cfs_quota_us", "-1");
  write("/sys/fs/cgroup/cpu,cpuacct/docker/77/cpu.cfs_period_us", "100000");
  EXPECT_EQ(chosen().threads, 8);
  write("/sys/fs/cgroup/cpu,cpuacct/docker/77/cpu.cfs_quota_us", "200000");
  EXPECT_EQ(chosen().threads, 2);
}

TEST_F(UsableCores, QuotaOfVersion1WhosePathIsThatOfTheHost) {
  write("/proc/self/cgroup", "4:cpuset:/y\n3:cpu:/docker/77");
  write("/sys/fs/cgroup/cpu/cpu.cfs_quota_us", "50000");
  write("/sys/fs/cgroup/cpu/cpu.cfs_period_us", "100000");
  EXPECT_EQ(chosen().threads, 1);
}

TEST_F(UsableCores, WrongFilesAreNoLimit) {
  write("/proc/self/cgroup", "no group\n0::/a");
  write("/sys/fs/cgroup/a/cpu.max", "many");
  EXPECT_EQ(coresOfQuota(here_), 0);
  write("/sys/fs/cgroup/a/cpu.max", "100000 0");
  EXPECT_EQ(coresOfQuota(here_), 0);
}

TEST_F(UsableCores, AffinityBoundsEverything) {
  here_.affinity = 2;
  EXPECT_EQ(chosen().threads, 2);
  EXPECT_EQ(chosen().because, "cores that the process may run on");
  EXPECT_TRUE(chosen().isLimit);
  variables_["SLURM_CPUS_PER_TASK"] = "4";
  EXPECT_EQ(chosen().threads, 2);
  EXPECT_EQ(chosen(5).threads, 2);
  write("/proc/self/cgroup", "0::/");
  write("/sys/fs/cgroup/cpu.max", "300000 100000");
  EXPECT_EQ(chosen().because, "cores that the process may run on") << "the smaller one";
}

TEST_F(UsableCores, SlurmComesBeforeOpenMp) {
  variables_["OMP_NUM_THREADS"] = "6,2";
  EXPECT_EQ(chosen().threads, 6) << "of the outermost level";
  EXPECT_EQ(chosen().because, "OMP_NUM_THREADS");
  variables_["SLURM_CPUS_PER_TASK"] = "4";
  EXPECT_EQ(chosen().threads, 4);
  EXPECT_EQ(chosen().because, "SLURM_CPUS_PER_TASK");
  EXPECT_EQ(chosen(7).threads, 7) << "the setting comes first";
  write("/proc/self/cgroup", "0::/");
  write("/sys/fs/cgroup/cpu.max", "300000 100000");
  EXPECT_EQ(chosen().threads, 3);
}

TEST_F(UsableCores, VariablesThatAreNoNumbersDoNotCount) {
  for (const char* wrong : {"", "0", "-2", "4x", "x4", "99999999999999"}) {
    variables_["SLURM_CPUS_PER_TASK"] = wrong;
    EXPECT_EQ(chosen().threads, 8) << wrong;
  }
}

TEST_F(UsableCores, RanksOfAHostShareItsCores) {
  here_.ranksHere = 3;
  EXPECT_EQ(chosen().threads, 2);
  EXPECT_EQ(chosen().because, "share of one of 3 ranks on this host");
  here_.ranksHere = 100;
  EXPECT_EQ(chosen().threads, 1) << "at least one";
  here_.affinity = 4;
  EXPECT_EQ(chosen().threads, 4) << "bound to its own cores";
  variables_["OMP_NUM_THREADS"] = "3";
  EXPECT_EQ(chosen().threads, 3);
}

TEST(UsableCoresOfThisProcess, AreThere) {
  EXPECT_GE(mostThreadsHere(), 1);
  EXPECT_GE(chosenThreadsHere(), 1);
  EXPECT_LE(chosenThreadsHere(), mostThreadsHere());
}

}  // namespace
}  // namespace gluray
