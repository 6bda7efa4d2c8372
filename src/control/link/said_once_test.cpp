#include "control/link/said_once.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace gluray::control {
namespace {

namespace fs = std::filesystem;

class SaidOnce : public testing::Test {
 protected:
  SaidOnce() {
    char folder[] = "/tmp/gluray-said-XXXXXX";
    directory_ = mkdtemp(folder);
  }
  ~SaidOnce() override { fs::remove_all(directory_); }

  /// How many of the job's ranks, each a process, say the line.
  int saying(const std::string& name, const std::string& line, int ranks, double began) {
    std::vector<pid_t> children;
    for (int rank = 0; rank < ranks; ++rank) {
      const pid_t child = fork();
      if (child == 0) _exit(saysLine({rank, ranks, name}, line, directory_, began) ? 1 : 0);
      children.push_back(child);
    }
    int count = 0;
    for (const pid_t child : children) {
      int status = 0;
      waitpid(child, &status, 0);
      count += WEXITSTATUS(status);
    }
    return count;
  }

  std::string directory_;
  const double now_ = static_cast<double>(time(nullptr));
};

TEST_F(SaidOnce, OneOfSixteenRanksSaysALine) {
  EXPECT_EQ(saying("job", "GLURAY_SPP=x: use a number", 16, now_), 1);
  EXPECT_EQ(saying("job", "GLURAY_SPP=x: use a number", 16, now_), 0) << "the claim stays";
  EXPECT_EQ(saying("job", "another line", 16, now_), 1);
  EXPECT_EQ(saying("another job", "another line", 16, now_), 1);
}

TEST_F(SaidOnce, WhoHasSaidALineMaySayItAgain) {
  EXPECT_TRUE(saysLine({0, 2, "job"}, "again", directory_, now_));
  EXPECT_TRUE(saysLine({0, 2, "job"}, "again", directory_, now_));
  EXPECT_EQ(saying("job", "again", 1, now_), 1) << "a program of one rank is no job";
}

TEST_F(SaidOnce, ClaimsOfAnEarlierJobDoNotCount) {
  EXPECT_EQ(saying("job", "line", 4, now_), 1);
  for (const auto& file : fs::directory_iterator(directory_))
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1));
  EXPECT_TRUE(saysLine({0, 4, "job"}, "line", directory_, now_)) << "of the same name, an hour later";
}

TEST_F(SaidOnce, OldClaimsAreRemoved) {
  EXPECT_EQ(saying("job", "line", 2, now_), 1);
  for (const auto& file : fs::directory_iterator(directory_))
    fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(48));
  std::ofstream(directory_ + "/hub.lock");
  EXPECT_EQ(saying("job 2", "another line", 2, now_), 1);
  EXPECT_EQ(std::distance(fs::directory_iterator(directory_), fs::directory_iterator()), 2)
      << "the new claim, and what is no claim";
}

TEST_F(SaidOnce, EveryoneSaysALineWhereNoClaimCanBeMade) {
  EXPECT_EQ(saying("", "line", 3, now_), 3) << "no name";
  chmod(directory_.c_str(), 0755);
  EXPECT_EQ(saying("job", "line", 3, now_), 3) << "others may write there";
}

TEST_F(SaidOnce, LinesNameTheRank) {
  EXPECT_EQ(withRank({3, 16, "job"}, "spp = x: use a number"),
            "spp = x: use a number (rank 3 of 16; once on this host)");
  EXPECT_EQ(withRank({}, "spp"), "spp");
}

}  // namespace
}  // namespace gluray::control
