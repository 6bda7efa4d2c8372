// Settings that change while a process runs because files are edited. live_changes_test.cpp tests values that
// are set live.
#include "settings/testing/live_fixture.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace gluray::test {
namespace {

TEST_F(Live, EditedFilesCountAtTheNextLook) {
  write(sources_.userFile, "spp = 2\n");
  EXPECT_EQ(live_.start(sources_).settings.spp, 2);
  write(sources_.userFile, "spp = 3\n");
  readWhenRested();
  EXPECT_EQ(spp(), 3);
  write(sources_.projectFile, "spp = 4\n");
  readWhenRested();
  EXPECT_EQ(spp(), 4);
  const uint64_t version = source_.version();
  write(sources_.projectFile, "spp = 4 # the same\n");
  readWhenRested();
  EXPECT_EQ(source_.version(), version);
  EXPECT_EQ(complaints_, std::vector<std::string>{});
}

TEST_F(Live, FilesThatAreBeingWrittenAreReadWhenTheyRest) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  std::ofstream(sources_.userFile, std::ios::trunc).flush();
  readWhenRested();
  EXPECT_EQ(spp(), 2) << "truncated";
  readWhenRested();
  EXPECT_EQ(spp(), 1) << "it stays empty";
  write(sources_.userFile, "spp = 2\n");
  readWhenRested();
  std::filesystem::remove(sources_.userFile);
  readWhenRested();
  EXPECT_EQ(spp(), 2) << "removed: another one may take its place";
  readWhenRested();
  EXPECT_EQ(spp(), 1);
}

TEST_F(Live, MistakesKeepTheLastSettings) {
  write(sources_.userFile, "spp = 2\nthreads = 3\n");
  live_.start(sources_);
  write(sources_.userFile, "spp = many\nthreads = 4\n");
  readWhenRested(), readWhenRested();
  EXPECT_EQ(spp(), 2);
  ASSERT_EQ(complaints_.size(), 1u) << "once for each change of the file";
  EXPECT_NE(complaints_[0].find("all settings stay as they are"), std::string::npos) << complaints_[0];
  write(sources_.userFile, "spp = 0\nthreads = 4\n");
  readWhenRested();
  EXPECT_EQ(spp(), 2);
  EXPECT_EQ(source_.current()->threads, 3);
  EXPECT_EQ(complaints_.size(), 2u);
  write(sources_.userFile, "spp = 5\n");
  readWhenRested();
  EXPECT_EQ(spp(), 5);
}

TEST_F(Live, MistakesFromTheStartDoNotMatter) {
  write(sources_.userFile, "spq = 2\n");
  live_.start(sources_);
  write(sources_.projectFile, "spp = 4\n");
  readWhenRested();
  EXPECT_EQ(spp(), 4);
  write(sources_.userFile, "# a line before it\nspq = 2\nthreads = 2\n");
  readWhenRested();
  EXPECT_EQ(source_.current()->threads, 2);
  EXPECT_EQ(complaints_.size(), 3u) << "it is reported each time that files are read";
}

TEST_F(Live, MistakesInFilesDoNotStopLiveChanges) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  write(sources_.userFile, "spp = many\n");
  readWhenRested();
  EXPECT_EQ(whyOf({{"ao.samples", "2"}}), "");
  EXPECT_EQ(source_.current()->ao.samples, 2);
  EXPECT_EQ(spp(), 2);
}

TEST_F(Live, LooksAreSeldom) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  readWhenRested();
  write(sources_.userFile, "spp = 3\n");
  std::this_thread::sleep_for(std::chrono::milliseconds(25));
  live_.readIfChanged(now_ + 0.9 * LiveSettings::kLookSeconds);
  EXPECT_EQ(spp(), 2);
  live_.readIfChanged(now_ + 100);
  EXPECT_EQ(spp(), 3);
}

TEST_F(Live, FilesOfSlowWritersAreReadAtOnceWhenTheyRest) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  readWhenRested();
  write(sources_.userFile, "spp = 3\n");
  live_.readIfChanged(now_ += 100);
  EXPECT_EQ(spp(), 2) << "written a moment ago";
  readWhenRested();
  EXPECT_EQ(spp(), 3);
}

TEST_F(Live, RightsCount) {
  live_.start(sources_);
  write(sources_.projectFile, "spp = 3\n");
  chmod(sources_.projectFile.c_str(), 0666);
  readWhenRested();
  EXPECT_EQ(spp(), 1);
  EXPECT_EQ(complaints_.size(), 1u);
  chmod(sources_.projectFile.c_str(), 0644);
  readWhenRested();
  EXPECT_EQ(spp(), 3);
}

TEST_F(Live, ManyThreadsMayLookAndChange) {
  write(sources_.userFile, "threads = 2\n");
  live_.start(sources_);
  std::thread other([&] {
    for (int i = 1; i <= 200; ++i) EXPECT_EQ(whyOf({{"spp", std::to_string(i)}}), "");
  });
  for (int i = 0; i < 200; ++i) {
    write(sources_.projectFile, "ao.samples = " + std::to_string(i + 1) + "\n");
    live_.readIfChanged(now_ += 1);
  }
  other.join();
  EXPECT_EQ(spp(), 200);
}

}  // namespace
}  // namespace gluray::test
