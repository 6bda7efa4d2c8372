// Values that are set live while a process runs: what they override, from which frame on, and how to undo
// them.
#include "settings/testing/live_fixture.h"

#include <atomic>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

namespace gluray::test {
namespace {

TEST_F(Live, LiveValuesOverrideFiles) {
  write(sources_.userFile, "spp = 2\n");
  live_.start(sources_);
  const LiveSettings::Answer answer = live_.change(Changes{{"spp", "8"}, {"ao", "on"}});
  EXPECT_EQ(answer.why, "");
  EXPECT_EQ(answer.version, source_.version());
  EXPECT_EQ(spp(), 8);
  EXPECT_TRUE(source_.current()->ao.enabled);
  write(sources_.userFile, "spp = 3\nthreads = 2\n");
  readWhenRested();
  EXPECT_EQ(spp(), 8);
  EXPECT_EQ(source_.current()->threads, 2);
  EXPECT_EQ(whyOf({{"spp", {}}}), "");
  EXPECT_EQ(spp(), 3) << "the other layers count again";
  EXPECT_TRUE(source_.current()->ao.enabled);
}

TEST_F(Live, PresetsAreSetLiveByName) {
  live_.start(sources_);
  EXPECT_EQ(whyOf({{"preset", "figure"}, {"spp", "2"}}), "");
  EXPECT_EQ(source_.current()->preset, "figure");
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

TEST_F(Live, ChangesMayWaitForAFrame) {
  write(sources_.userFile, "threads = 2\n");
  live_.start(sources_);
  uint64_t version = source_.version();
  const LiveSettings::Answer answer = live_.change(Changes{{"spp", "8"}}, 3);
  EXPECT_EQ(answer.why, "");
  source_.endFrame();
  EXPECT_EQ(source_.takeNewer(version), nullptr);
  EXPECT_EQ(spp(), 1);
  EXPECT_FALSE(live_.firstFrameWith(answer));
  write(sources_.userFile, "threads = 3\n");
  readWhenRested();
  EXPECT_EQ(source_.current()->threads, 3);
  EXPECT_EQ(spp(), 1);
  source_.endFrame(), source_.beginFrame();
  ASSERT_TRUE(source_.takeNewer(version));
  EXPECT_EQ(spp(), 8);
  EXPECT_EQ(source_.current()->threads, 3) << "files that changed meanwhile count, too";
  EXPECT_EQ(live_.firstFrameWith(answer), 3u);
  write(sources_.userFile, "threads = 4\n");
  readWhenRested();
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
  source_.endFrame(), source_.takeNewer(version), source_.beginFrame();
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
  source_.endFrame(), source_.takeNewer(version), source_.beginFrame();
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

TEST_F(Live, FramesOfTwoContextsAndChangesOverlap) {
  live_.start(sources_);
  std::atomic<bool> done{false};
  const auto draw = [&] {
    uint64_t version = 0;
    while (!done) {
      source_.endFrame(), source_.takeNewer(version);
      source_.beginFrame(), source_.takeNewer(version);
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
}  // namespace gluray::test
