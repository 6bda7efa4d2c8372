// Rows added only to spec/settings.toml appear in structs, files, variables, options and messages.
#include "command_line.h"
#include "settings/layers/settings_layers.h"
#include "settings/values.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gluray {
namespace {

std::vector<std::string> g_complaints;

void complain(const std::string& line) { g_complaints.push_back(line); }

Session expected() {
  Session session;
  session.settings.added.enabled = true;
  session.settings.added.count = 7;
  session.settings.added.radius = 2.5f;
  session.settings.added.deep.firstMode = AddedDeepFirstMode::low;
  session.settings.added.sky = {1, 0, 0};
  session.settings.added.up = {0, 1, 0};
  session.added.title = "t";
  session.added.file = "/f";
  session.added.names = {"x", "y"};
  return session;
}

class Added : public testing::Test {
 protected:
  Added() : file_(testing::TempDir() + "gluray-added-" + std::to_string(getpid()) + ".toml") {
    g_complaints.clear();
  }
  ~Added() override {
    std::filesystem::remove(file_);
    for (const Row& row : settingRows()) unsetenv(variableOf(row).c_str());
  }
  Session ofFile(const std::string& text) {
    std::ofstream(file_) << text;
    Sources sources;
    sources.userFile = file_;
    return readLayers(sources, complain).session;
  }
  /// Values chosen by options.
  static Session ofOptions(std::vector<std::string> words) {
    std::vector<char*> arguments{const_cast<char*>("gluray")};
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(const_cast<char*>("program"));
    const launcher::Parsed parsed = launcher::parse(static_cast<int>(arguments.size()), arguments.data());
    EXPECT_TRUE(parsed.run);
    Sources sources;
    sources.commandLine = launcher::passedValues(parsed.commandLine.settings);
    return readLayers(sources, complain).session;
  }
  std::string file_;
};

TEST_F(Added, StructsHaveThemWithTheirDefaults) {
  const Session session;
  EXPECT_FALSE(session.settings.added.enabled);
  EXPECT_EQ(session.settings.added.count, 2);
  EXPECT_EQ(session.settings.added.radius, 0.5f);
  EXPECT_EQ(session.settings.added.deep.firstMode, AddedDeepFirstMode::veryHigh);
  EXPECT_EQ(session.settings.added.sky, glm::vec3(0.25f, 0.5f, 1));
  EXPECT_EQ(session.settings.added.up, glm::vec3(0, 0, 1));
  EXPECT_EQ(session.added.title, "it's \"new\"");
  EXPECT_EQ(session.added.file, "");
  EXPECT_EQ(session.added.names, (std::vector<std::string>{"a", "b"}));
}

TEST_F(Added, FilesSetThem) {
  EXPECT_EQ(ofFile(R"(
[added]
enabled = true
title = "t"
count = 7
radius = 2.5
sky = "#ff0000"
up = [0, 1, 0]
file = "/f"
names = ["x", "y"]
[added.deep]
first-mode = "low"
)"),
            expected());
  EXPECT_EQ(g_complaints, std::vector<std::string>{});
}

TEST_F(Added, FilesMayWriteDots) {
  EXPECT_EQ(ofFile("added.count = 7\nadded.deep.first-mode = \"low\"\n").settings.added.count, 7);
  EXPECT_EQ(g_complaints, std::vector<std::string>{});
}

TEST_F(Added, VariablesSetThem) {
  const std::pair<const char*, const char*> variables[] = {
      {"GLURAY_ADDED_ENABLED", "1"},  {"GLURAY_ADDED_COUNT", "7"},
      {"GLURAY_ADDED_RADIUS", "2.5"}, {"GLURAY_ADDED_DEEP_FIRST_MODE", "low"},
      {"GLURAY_ADDED_SKY", "1,0,0"},  {"GLURAY_ADDED_UP", "0,1,0"},
      {"GLURAY_ADDED_TITLE", "t"},    {"GLURAY_ADDED_FILE", "/f"},
      {"GLURAY_ADDED_NAMES", "x,y"}};
  for (const auto& [name, value] : variables) setenv(name, value, 1);
  EXPECT_EQ(readLayers({}, complain).session, expected());
  EXPECT_EQ(g_complaints, std::vector<std::string>{});
}

TEST_F(Added, SetSetsThem) {
  EXPECT_EQ(
      ofOptions({"--set", "added.enabled=true", "--set", "added.count=7", "--set", "added.radius=2.5",
                 "--set", "added.deep.first-mode=low", "--set=added.sky=#ff0000", "--set", "added.up=0,1,0",
                 "--set", "added.title=t", "--set", "added.file=/f", "--set", "added.names=x,y"}),
      expected());
}

TEST_F(Added, OptionsOfTheirOwnSetThem) {
  const Session session = ofOptions({"--added", "--added-radius", "3", "--added-mode=low", "--added-file",
                                     "relative", "--added-name", "x", "--added-name", "y"});
  EXPECT_TRUE(session.settings.added.enabled);
  EXPECT_EQ(session.settings.added.radius, 3);
  EXPECT_EQ(session.settings.added.deep.firstMode, AddedDeepFirstMode::low);
  EXPECT_EQ(session.added.file, std::filesystem::absolute("relative"));
  EXPECT_EQ(session.added.names, (std::vector<std::string>{"x", "y"}));
}

TEST_F(Added, TheLastOptionWins) {
  EXPECT_EQ(ofOptions({"--added-radius", "3", "--set", "added.radius=4"}).settings.added.radius, 4);
  EXPECT_EQ(ofOptions({"--set", "added.radius=4", "--added-radius", "3"}).settings.added.radius, 3);
}

TEST_F(Added, HelpDescribesTheirOptions) {
  char program[] = "gluray", help[] = "--help";
  char* words[] = {program, help};
  testing::internal::CaptureStdout();
  launcher::parse(2, words);
  const std::string text = testing::internal::GetCapturedStdout();
  for (const char* part : {"--added ", "Adds a switch\n", "--added-radius X", "Adds a number [0.5]",
                           "--added-mode low|very-high", "very-high: adds much"})
    EXPECT_NE(text.find(part), text.npos) << part << " in\n" << text;
}

TEST_F(Added, OptionsRefuseWrongValuesInOneLine) {
  for (const auto& [word, value, line] :
       {std::tuple{"--added-radius", "11", "use a number from 0 (nothing) to 10 ms"},
        std::tuple{"--added-mode", "high", "use low or very-high"},
        std::tuple{"--set", "added.sky=blue", "use #rrggbb"},
        std::tuple{"--set", "added.cuont=3", "did you mean 'added.count'?"},
        std::tuple{"--set", "added", "use NAME=VALUE"}}) {
    std::string words[] = {"gluray", word, value, "program"};
    char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data()};
    testing::internal::CaptureStderr();
    const launcher::Parsed parsed = launcher::parse(4, arguments);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_FALSE(parsed.run);
    EXPECT_EQ(parsed.exitCode, 2);
    EXPECT_NE(said.find(line), said.npos) << said;
    EXPECT_EQ(said.find('\n'), said.size() - 1) << said;
  }
}

TEST_F(Added, MistakesInFilesAreReported) {
  EXPECT_EQ(
      ofFile("[added]\ncount = 9\nradios = 1\nup = [1, 2]\ndeep.first-mode = \"high\"\nsky = {r = 1}\n"),
      Session{});
  EXPECT_EQ(g_complaints, (std::vector<std::string>{
                              file_ + ":2: added.count = 9: use a number from 1 to 8",
                              file_ + ":3: no setting is called 'added.radios'; did you mean 'added.radius'?",
                              file_ + ":4: added.up = 1,2: use three numbers with commas between them",
                              file_ + ":5: added.deep.first-mode = high: use low or very-high",
                              file_ + ":6: added.sky: use a string or an array"}));
}

TEST_F(Added, TheyChangeTheImageWhereTheirRowsSaySo) {
  Settings settings;
  settings.added.count = 3, settings.added.deep.firstMode = AddedDeepFirstMode::low;
  EXPECT_FALSE(settings.changesImage());
  settings.added.sky.b = 0;
  EXPECT_TRUE(settings.changesImage());
  Settings next, old;
  next.added.count = 3, next.added.deep.firstMode = AddedDeepFirstMode::low;
  keepBetweenFrames(next, old);  // the mode applies to contexts
  EXPECT_EQ(next.added.count, 3);
  EXPECT_EQ(next.added.deep.firstMode, AddedDeepFirstMode::veryHigh);
}

TEST_F(Added, EverySettingReadsWhatItPrints) {
  const Session from = expected();
  Session to;
  for (const Row& row : settingRows()) EXPECT_EQ(readValue(row, printValue(row, from), to), "") << row.name;
  EXPECT_EQ(to, from);
}

}  // namespace
}  // namespace gluray
