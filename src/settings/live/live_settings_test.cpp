// Settings that change while a process runs: files that are edited, and values that are set live.
#include "settings/live/live_settings.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace gluray {
namespace {

using Changes = std::vector<LiveSettings::Change>;

class Live : public testing::Test {
 protected:
  Live() : folder_(testing::TempDir() + "gluray-live-" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
    sources_.userFile = (folder_ / "user.toml").string();
    sources_.projectFile = (folder_ / "gluray.toml").string();
    sources_.variables.emplace();
  }
  ~Live() override { std::filesystem::remove_all(folder_); }

  static void write(const std::string& file, const std::string& text) {
    std::ofstream(file) << text;
    chmod(file.c_str(), 0644);
  }
  /// Looks when the files have rested, as far as LiveSettings knows the time.
  void look() {
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    live_.look(now_ += 100);
  }
  int spp() const { return source_.current()->spp; }
  std::string whyOf(const Changes& changes) { return live_.change(changes).why; }

  std::filesystem::path folder_;
  double now_ = 1000;
  Sources sources_;
  SettingsSource source_;
  std::vector<std::string> complaints_;
  LiveSettings live_{source_, [this](const std::string& line) { complaints_.push_back(line); }};
};

TEST_F(Live, EditedFilesCountAtTheNextLook) {
  write(sources_.userFile, "spp = 2\n");
  EXPECT_EQ(live_.start(sources_).settings.spp, 2);
  write(sources_.userFile, "spp = 3\n");
  look();
  EXPECT_EQ(spp(), 3);
  write(sources_.projectFile, "spp = 4\n");
  look();
  EXPECT_EQ(spp(), 4);
  const uint64_t version = source_.version();
  write(sources_.projectFile, "spp = 4 # the same\n");
  look();
  EXPECT_EQ(source_.version(), version);
  EXPECT_EQ(complaints_, std::vector<std::string>{});
}

TEST_F(Live, FilesThatAreBeingWrittenAreReadWhenTheyRest) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  std::ofstream(sources_.userFile, std::ios::trunc).flush();
  look();
  EXPECT_EQ(spp(), 2) << "truncated";
  look();
  EXPECT_EQ(spp(), 1) << "it stays empty";
  write(sources_.userFile, "spp = 2\n");
  look();
  std::filesystem::remove(sources_.userFile);
  look();
  EXPECT_EQ(spp(), 2) << "removed: another one may take its place";
  look();
  EXPECT_EQ(spp(), 1);
}

TEST_F(Live, MistakesKeepTheLastSettings) {
  write(sources_.userFile, "spp = 2\nthreads = 3\n");
  live_.start(sources_);
  write(sources_.userFile, "spp = many\nthreads = 4\n");
  look(), look();
  EXPECT_EQ(spp(), 2);
  ASSERT_EQ(complaints_.size(), 1u) << "once for each change of the file";
  EXPECT_NE(complaints_[0].find("all settings stay as they are"), std::string::npos) << complaints_[0];
  write(sources_.userFile, "spp = 0\nthreads = 4\n");
  look();
  EXPECT_EQ(spp(), 2);
  EXPECT_EQ(source_.current()->threads, 3);
  EXPECT_EQ(complaints_.size(), 2u);
  write(sources_.userFile, "spp = 5\n");
  look();
  EXPECT_EQ(spp(), 5);
}

TEST_F(Live, MistakesFromTheStartDoNotMatter) {
  write(sources_.userFile, "spq = 2\n");
  live_.start(sources_);
  write(sources_.projectFile, "spp = 4\n");
  look();
  EXPECT_EQ(spp(), 4);
  write(sources_.userFile, "# a line before it\nspq = 2\nthreads = 2\n");
  look();
  EXPECT_EQ(source_.current()->threads, 2);
  EXPECT_EQ(complaints_.size(), 3u) << "it is reported each time that files are read";
}

TEST_F(Live, MistakesInFilesDoNotStopLiveChanges) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  write(sources_.userFile, "spp = many\n");
  look();
  EXPECT_EQ(whyOf({{"ao.samples", "2"}}), "");
  EXPECT_EQ(source_.current()->ao.samples, 2);
  EXPECT_EQ(spp(), 2);
}

TEST_F(Live, LiveValuesOverrideFiles) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  const LiveSettings::Answer answer = live_.change(Changes{{"spp", "8"}, {"ao", "on"}});
  EXPECT_EQ(answer.why, "");
  EXPECT_EQ(answer.version, source_.version());
  EXPECT_EQ(spp(), 8);
  EXPECT_TRUE(source_.current()->ao.enabled);
  write(sources_.userFile, "spp = 3\nthreads = 2\n");
  look();
  EXPECT_EQ(spp(), 8);
  EXPECT_EQ(source_.current()->threads, 2);
  EXPECT_EQ(whyOf({{"spp", {}}}), "");
  EXPECT_EQ(spp(), 3) << "the other layers count again";
  EXPECT_TRUE(source_.current()->ao.enabled);
}

TEST_F(Live, PresetsAreSetLiveByName) {
  live_.start(sources_);
  EXPECT_EQ(whyOf({{"preset", "publication"}, {"spp", "2"}}), "");
  EXPECT_EQ(source_.current()->preset, "publication");
  EXPECT_TRUE(source_.current()->shadows.enabled);
  EXPECT_EQ(spp(), 2);
  EXPECT_EQ(whyOf({{"preset", "draft"}}), "");
  EXPECT_FALSE(source_.current()->shadows.enabled);
  EXPECT_EQ(spp(), 2);
}

TEST_F(Live, WrongChangesChangeNothing) {
  live_.start(sources_);
  EXPECT_EQ(whyOf({{"spp", "2"}, {"sp", "3"}}), "no setting is called 'sp'; did you mean 'spp'?");
  EXPECT_EQ(whyOf({{"spp", "0"}}), "spp=0: use a number from 1 (the centre) to 1024");
  EXPECT_EQ(whyOf({{"preset", "drft"}}), "preset=drft: there is no such preset; did you mean 'draft'?");
  EXPECT_EQ(whyOf({{"report", "/a"}}),
            "report applies to the next run only; set it in gluray.toml or as an option");
  EXPECT_EQ(*source_.current(), Settings{});
  EXPECT_EQ(complaints_, std::vector<std::string>{});
}

TEST_F(Live, LooksAreSeldom) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  look();
  write(sources_.userFile, "spp = 3\n");
  std::this_thread::sleep_for(std::chrono::milliseconds(25));
  live_.look(now_ + 0.9 * LiveSettings::kLookSeconds);
  EXPECT_EQ(spp(), 2);
  live_.look(now_ + 100);
  EXPECT_EQ(spp(), 3);
}

TEST_F(Live, FilesOfSlowWritersAreReadAtOnceWhenTheyRest) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  look();
  write(sources_.userFile, "spp = 3\n");
  live_.look(now_ += 100);
  EXPECT_EQ(spp(), 2) << "written a moment ago";
  look();
  EXPECT_EQ(spp(), 3);
}

TEST_F(Live, RightsCount) {
  live_.start(sources_);
  write(sources_.projectFile, "spp = 3\n");
  chmod(sources_.projectFile.c_str(), 0666);
  look();
  EXPECT_EQ(spp(), 1);
  EXPECT_EQ(complaints_.size(), 1u);
  chmod(sources_.projectFile.c_str(), 0644);
  look();
  EXPECT_EQ(spp(), 3);
}

TEST_F(Live, ChangesMayWaitForAFrame) {
  write(sources_.userFile, "threads = 2\n");
  live_.start(sources_);
  uint64_t version = source_.version();
  const LiveSettings::Answer answer = live_.change(Changes{{"spp", "8"}}, 3);
  EXPECT_EQ(answer.why, "");
  source_.endFrame();
  EXPECT_EQ(source_.take(version), nullptr);
  EXPECT_EQ(spp(), 1);
  EXPECT_FALSE(live_.firstFrameWith(answer));
  write(sources_.userFile, "threads = 3\n");
  look();
  EXPECT_EQ(source_.current()->threads, 3);
  EXPECT_EQ(spp(), 1);
  source_.endFrame(), source_.beginFrame();
  ASSERT_TRUE(source_.take(version));
  EXPECT_EQ(spp(), 8);
  EXPECT_EQ(source_.current()->threads, 3) << "files that changed meanwhile count, too";
  EXPECT_EQ(live_.firstFrameWith(answer), 3u);
  write(sources_.userFile, "threads = 4\n");
  look();
  EXPECT_EQ(spp(), 8);
  EXPECT_EQ(source_.current()->threads, 4);
}

TEST_F(Live, SettingsOfContextsAndProcessesAreRefused) {
  live_.start(sources_);
  EXPECT_EQ(whyOf({{"threads", "2"}}),
            "threads applies when windows are made; set it in gluray.toml or as an option");
  EXPECT_EQ(whyOf({{"log", "/tmp/x"}}),
            "log applies to the next run only; set it in gluray.toml or as an option");
}

TEST_F(Live, ChangesThatWaitCountWithLaterOnes) {
  live_.start(sources_);
  const LiveSettings::Answer waits = live_.change(Changes{{"spp", "8"}}, 50);
  const LiveSettings::Answer answer = live_.change(Changes{{"ao.samples", "3"}});
  EXPECT_EQ(spp(), 8);
  EXPECT_EQ(source_.current()->ao.samples, 3);
  uint64_t version = 0;
  source_.endFrame(), source_.take(version), source_.beginFrame();
  EXPECT_EQ(live_.firstFrameWith(waits), 2u);
  EXPECT_EQ(live_.firstFrameWith(answer), 2u);
  EXPECT_EQ(whyOf({{"spp", {}}}), "");
  EXPECT_EQ(spp(), 1);
}

TEST_F(Live, FramesThatHaveBegunAreNotWaitedFor) {
  live_.start(sources_);
  for (int i = 0; i < 9; ++i) source_.endFrame();
  const LiveSettings::Answer answer = live_.change(Changes{{"spp", "8"}}, 5);
  EXPECT_EQ(spp(), 8);
  uint64_t version = 0;
  source_.endFrame(), source_.take(version), source_.beginFrame();
  EXPECT_EQ(live_.firstFrameWith(answer), 11u);
}

TEST_F(Live, AnswersSayHowToUndo) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  Changes before = live_.change(Changes{{"spp", "8"}, {"ao", "on"}}).before;
  ASSERT_EQ(before.size(), 2u);
  EXPECT_FALSE(before[0].value);
  before = live_.change(Changes{{"spp", "9"}}).before;
  EXPECT_EQ(before[0].value, "8");
  EXPECT_EQ(live_.change(before).why, "");
  EXPECT_EQ(spp(), 8);
}

TEST_F(Live, ValuesHaveTheirLayers) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  const uint64_t revision = live_.revision();
  EXPECT_EQ(whyOf({{"ao", "on"}}), "");
  EXPECT_GT(live_.revision(), revision);
  std::map<std::string_view, LiveSettings::Value> values;
  for (const LiveSettings::Value& v : live_.values()) values.emplace(v.row->name, v);
  EXPECT_EQ(values.at("spp").text, "2");
  EXPECT_EQ(values.at("spp").layer, Layer::user);
  EXPECT_EQ(values.at("spp").place, sources_.userFile + ":1");
  EXPECT_EQ(values.at("ao").text, "true");
  EXPECT_EQ(values.at("ao").layer, Layer::live);
  EXPECT_EQ(values.at("threads").layer, Layer::builtIn);
  EXPECT_EQ(values.at("threads").place, "");
  EXPECT_EQ(live_.whyNot(Changes{{"spp", "0"}}), "spp=0: use a number from 1 (the centre) to 1024");
  EXPECT_EQ(live_.whyNot(Changes{{"spp", "4"}}), "");
  EXPECT_EQ(spp(), 2);
}

TEST_F(Live, ManyThreadsMayLookAndChange) {
  write(sources_.userFile, "threads = 2\n");
  live_.start(sources_);
  std::thread other([&] {
    for (int i = 1; i <= 200; ++i) EXPECT_EQ(whyOf({{"spp", std::to_string(i)}}), "");
  });
  for (int i = 0; i < 200; ++i) {
    write(sources_.projectFile, "ao.samples = " + std::to_string(i + 1) + "\n");
    live_.look(now_ += 1);
  }
  other.join();
  EXPECT_EQ(spp(), 200);
}

TEST_F(Live, FramesOfTwoContextsAndChangesOverlap) {
  live_.start(sources_);
  std::atomic<bool> done{false};
  const auto draw = [&] {
    uint64_t version = 0;
    while (!done) {
      source_.endFrame(), source_.take(version);
      source_.beginFrame(), source_.take(version);
    }
  };
  std::thread one(draw), two(draw);
  for (int i = 2; i <= 300; ++i) {
    const uint64_t frame = i % 2 ? source_.frame() + 3 : 0;
    const LiveSettings::Answer answer = live_.change(Changes{{"spp", std::to_string(i)}}, frame);
    ASSERT_EQ(answer.why, "");
    std::optional<uint64_t> first;
    while (!(first = live_.firstFrameWith(answer))) std::this_thread::yield();
    EXPECT_GE(*first, frame);
    EXPECT_EQ(spp(), i);
  }
  done = true;
  one.join(), two.join();
}

}  // namespace
}  // namespace gluray
