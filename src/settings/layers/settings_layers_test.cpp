// Precedence of layers, origins of values, and refused files.
#include "settings/layers/settings_layers.h"

#include "settings/layers/presets.h"
#include "settings/values.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gluray {
namespace {

std::vector<std::string> g_layerComplaints;

class LayersOf : public testing::Test {
 protected:
  LayersOf() : folder_(testing::TempDir() + "gluray-layers-" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_);
    for (const Row& row : settingRows()) unsetenv(variableOf(row).c_str());
    g_layerComplaints.clear();
  }
  ~LayersOf() override {
    std::filesystem::remove_all(folder_);
    for (const Row& row : settingRows()) unsetenv(variableOf(row).c_str());
  }

  std::string file(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    chmod((folder_ / name).c_str(), 0644);
    return (folder_ / name).string();
  }
  /// The setting as "value (layer place)".
  std::string read(std::string_view name) {
    const Layers layers =
        readLayers(sources_, [](const std::string& line) { g_layerComplaints.push_back(line); });
    const Given* given = layers.last(*findSetting(name));
    return given ? given->value + " (" + std::string(nameOf(given->layer)) + " " + given->place + ")" : "";
  }
  std::filesystem::path folder_;
  Sources sources_;
};

TEST_F(LayersOf, LaterOnesWin) {
  EXPECT_EQ(read("spp"), "");
  sources_.systemFile = file("system.toml", "\nspp = 2\n");
  EXPECT_EQ(read("spp"), "2 (system " + sources_.systemFile + ":2)");
  sources_.userFile = file("user.toml", "spp = 3\n");
  EXPECT_EQ(read("spp"), "3 (user " + sources_.userFile + ":1)");
  sources_.projectFile = file("project.toml", "spp = 4\n");
  EXPECT_EQ(read("spp"), "4 (project " + sources_.projectFile + ":1)");
  sources_.programs = {"viewer"};
  sources_.systemFile = file("system.toml", "spp = 2\n[program.viewer]\nspp = 5\n[program.other]\nspp = 9\n");
  EXPECT_EQ(read("spp"), "5 (program " + sources_.systemFile + ":3)");
  setenv("GLURAY_SPP", "6", 1);
  EXPECT_EQ(read("spp"), "6 (environment GLURAY_SPP)");
  sources_.commandLine = {{"spp", "7"}};
  EXPECT_EQ(read("spp"), "7 (command line --spp)");
  EXPECT_EQ(g_layerComplaints, std::vector<std::string>{});
}

TEST_F(LayersOf, SettingsAreLookedUpOneByOne) {
  sources_.systemFile = file("system.toml", "spp = 2\nthreads = 2\n");
  sources_.userFile = file("user.toml", "threads = 3\n");
  EXPECT_EQ(read("spp"), "2 (system " + sources_.systemFile + ":1)");
  EXPECT_EQ(read("threads"), "3 (user " + sources_.userFile + ":1)");
}

TEST_F(LayersOf, ProfilesOfLaterFilesAndLaterNamesWin) {
  sources_.systemFile = file("system.toml", "[program.python3]\nspp = 2\n[program.\"plot.py\"]\nspp = 3\n");
  sources_.userFile = file("user.toml", "[program.python3]\nspp = 4\n");
  sources_.programs = {"python3"};
  EXPECT_EQ(read("spp"), "4 (program " + sources_.userFile + ":2)");
  sources_.programs = {"python3", "plot.py"};
  EXPECT_EQ(read("spp"), "3 (program " + sources_.systemFile + ":4)");
  sources_.programs = {"perl"};
  EXPECT_EQ(read("spp"), "");
}

TEST_F(LayersOf, PresetsAreBetweenProfilesAndVariables) {
  sources_.programs = {"viewer"};
  sources_.userFile =
      file("user.toml", "preset = 'mine'\nspp = 2\n[program.viewer]\nspp = 3\n[presets.mine]\nspp = 4\n");
  EXPECT_EQ(read("spp"), "4 (preset mine, " + sources_.userFile + ":6)");
  EXPECT_EQ(read("preset"), "mine (user " + sources_.userFile + ":1)");
  setenv("GLURAY_SPP", "5", 1);
  EXPECT_EQ(read("spp"), "5 (environment GLURAY_SPP)");
  unsetenv("GLURAY_SPP");
  sources_.live = {{"spp", "6"}};
  EXPECT_EQ(read("spp"), "6 (live )");
  EXPECT_EQ(g_layerComplaints, std::vector<std::string>{});
}

TEST_F(LayersOf, TheHighestLayerNamesThePreset) {
  sources_.userFile =
      file("user.toml", "preset = 'a'\n[presets.a]\nspp = 2\n[presets.b]\nspp = 3\n[presets.c]\nspp = 4\n");
  sources_.projectFile = file("project.toml", "preset = 'b'\n");
  EXPECT_EQ(read("spp"), "3 (preset b, " + sources_.userFile + ":5)");
  sources_.programs = {"viewer"};
  sources_.systemFile = file("system.toml", "[program.viewer]\npreset = 'c'\n");
  EXPECT_EQ(read("spp"), "4 (preset c, " + sources_.userFile + ":7)");
  setenv("GLURAY_PRESET", "a", 1);
  EXPECT_EQ(read("spp"), "2 (preset a, " + sources_.userFile + ":3)");
  sources_.commandLine = {{"preset", "b"}};
  EXPECT_EQ(read("spp"), "3 (preset b, " + sources_.userFile + ":5)");
  for (const char* none : {"none", ""}) {
    sources_.live = {{"preset", none}};
    EXPECT_EQ(read("spp"), "");
  }
  EXPECT_EQ(g_layerComplaints, std::vector<std::string>{});
  sources_.live = {{"preset", "bb"}};
  EXPECT_EQ(read("spp"), "3 (preset b, " + sources_.userFile + ":5)") << "wrong values change nothing";
  EXPECT_EQ(read("preset"), "b (command line --preset)");
  EXPECT_EQ(g_layerComplaints[0], "preset=bb: there is no such preset; did you mean 'b'?");
}

TEST_F(LayersOf, QualityIsAPresetAboveThePreset) {
  sources_.userFile = file("user.toml",
                           "[presets.mine]\nspp = 2\nao = true\n[presets.better]\nquality = 'good'\n"
                           "[presets.quality-good]\nspp = 3\n");
  sources_.commandLine = {{"preset", "mine"}, {"quality", "good"}};
  EXPECT_EQ(read("spp"), "3 (preset quality-good, " + sources_.userFile + ":7)");
  EXPECT_EQ(read("ao"), "true (preset mine, " + sources_.userFile + ":3)");
  EXPECT_EQ(read("noise"), "0.01 (preset quality-good, shipped)");
  sources_.live = {{"quality", "none"}};
  EXPECT_EQ(read("spp"), "2 (preset mine, " + sources_.userFile + ":2)");
  sources_.live = {{"quality", "fine"}};
  EXPECT_EQ(read("spp"), "3 (preset quality-good, " + sources_.userFile + ":7)")
      << "wrong values change nothing";
  EXPECT_EQ(g_layerComplaints.size(), 1u);
  sources_.live = {{"preset", "better"}};
  sources_.commandLine.clear();
  EXPECT_EQ(read("spp"), "3 (preset quality-good, " + sources_.userFile + ":7)") << "presets may name one";
  sources_.live.push_back({"spp", "5"});
  EXPECT_EQ(read("spp"), "5 (live )");
}

TEST_F(LayersOf, FilesAddToPresets) {
  sources_.commandLine = {{"preset", "draft"}};
  EXPECT_EQ(read("ao"), "false (preset draft, shipped)");
  sources_.userFile = file("user.toml", "[presets.draft]\nhelp = 'mine'\nthreads = 2\nspp = 2\n");
  sources_.projectFile = file("project.toml", "[presets.draft]\nspp = 3\n");
  EXPECT_EQ(read("ao"), "false (preset draft, shipped)");
  EXPECT_EQ(read("threads"), "2 (preset draft, " + sources_.userFile + ":3)");
  EXPECT_EQ(read("spp"), "3 (preset draft, " + sources_.projectFile + ":2)");
  EXPECT_EQ(g_layerComplaints, std::vector<std::string>{});
}

TEST_F(LayersOf, WrongPresetsAreReported) {
  sources_.userFile = file("user.toml", "preset = 'drat'\n");
  read("spp");
  EXPECT_EQ(g_layerComplaints,
            std::vector<std::string>{sources_.userFile +
                                     ":1: preset = drat: there is no such preset; did you mean 'draft'?"});
  g_layerComplaints.clear();
  sources_.userFile =
      file("user.toml", "preset = 'mine'\n[presets.mine]\nsp = 2\nao.samples = 0\npreset = 'draft'\n");
  read("spp");
  EXPECT_EQ(g_layerComplaints,
            (std::vector<std::string>{
                sources_.userFile + ":3: no setting is called 'sp'; did you mean 'spp'?",
                "mine, " + sources_.userFile + ":4: ao.samples = 0: use a number from 1 to 4096 rays",
                sources_.userFile + ":5: preset: a preset cannot name another"}));
  g_layerComplaints.clear();
  sources_.userFile = file("user.toml", "presets = 3\n");
  read("spp");
  EXPECT_EQ(g_layerComplaints,
            std::vector<std::string>{sources_.userFile + ":1: presets: use tables such as [presets.mine]"});
  g_layerComplaints.clear();
  sources_.userFile = file("user.toml", "[presets.none]\nspp = 2\n");
  read("spp");
  EXPECT_EQ(g_layerComplaints,
            std::vector<std::string>{sources_.userFile + ":1: presets.none: a preset needs another name"});
}

TEST(Presets, AreAllRight) {
  const std::vector<Preset> all = allPresets({});
  std::vector<std::string> names;
  for (const Preset& preset : all) {
    names.push_back(preset.name);
    EXPECT_FALSE(preset.help.empty()) << preset.name;
    for (const PresetValue& v : preset.values) {
      ASSERT_EQ(v.wrong, "") << preset.name;
      Session session;
      EXPECT_EQ(readValue(*findSetting(v.name), v.value, session), "") << preset.name << ": " << v.name;
    }
  }
  EXPECT_EQ(names, (std::vector<std::string>{"draft", "honest", "presentation", "figure", "poster",
                                             "streamlines", "molecule", "metal", "outdoor", "ospray",
                                             "quality-draft", "quality-good", "quality-final"}));
}

TEST_F(LayersOf, WrongProfilesAreReported) {
  sources_.userFile = file("user.toml", "[program.viewer]\nsp = 2\n");
  sources_.programs = {"viewer"};
  read("spp");
  sources_.userFile = file("user.toml", "program = \"viewer\"\n");
  read("spp");
  ASSERT_EQ(g_layerComplaints.size(), 2u);
  EXPECT_EQ(g_layerComplaints[0], sources_.userFile + ":2: no setting is called 'sp'; did you mean 'spp'?");
  EXPECT_EQ(g_layerComplaints[1], sources_.userFile + ":1: program: use tables such as [program.glxgears]");
}

TEST_F(LayersOf, PassedOptionsAreKnownUntilTheVariableChanges) {
  sources_.passed = true;
  sources_.commandLine = {{"spp", "7"}, {"threads", "2"}};
  setenv("GLURAY_SPP", "7", 1);
  EXPECT_EQ(read("spp"), "7 (command line --spp)");
  EXPECT_EQ(read("threads"), "");  // unset again
  setenv("GLURAY_SPP", "8", 1);
  EXPECT_EQ(read("spp"), "8 (environment GLURAY_SPP)");
}

TEST_F(LayersOf, WrongValuesChangeNothing) {
  sources_.userFile = file("user.toml", "spp = 3\n");
  setenv("GLURAY_SPP", "many", 1);
  EXPECT_EQ(read("spp"), "3 (user " + sources_.userFile + ":1)");
  EXPECT_EQ(g_layerComplaints,
            std::vector<std::string>{"GLURAY_SPP=many: use a number from 1 (the centre) to 1024"});
}

TEST_F(LayersOf, FilesThatOthersMayWriteAreNotRead) {
  sources_.projectFile = file("project.toml", "report = \"/planted.json\"\n");
  EXPECT_NE(read("report"), "");
  chmod(sources_.projectFile.c_str(), 0646);
  EXPECT_EQ(read("report"), "");
  EXPECT_EQ(g_layerComplaints, std::vector<std::string>{sources_.projectFile + ": others may write it"});
  g_layerComplaints.clear();
  sources_.systemFile = sources_.projectFile, sources_.projectFile.clear();
  EXPECT_EQ(read("report"), "");
  EXPECT_EQ(g_layerComplaints.size(), 1u);
  // The user's own file is always read.
  sources_.userFile = sources_.systemFile, sources_.systemFile.clear();
  EXPECT_NE(read("report"), "");
}

TEST_F(LayersOf, FilesOfOthersAreNotRead) {
  sources_.projectFile = file("project.toml", "report = \"/planted.json\"\n");
  constexpr uid_t kNobody = 65534;
  if (chown(sources_.projectFile.c_str(), kNobody, getegid()) != 0)
    GTEST_SKIP() << "only root gives files away";
  EXPECT_EQ(read("report"), "");
  EXPECT_EQ(g_layerComplaints,
            std::vector<std::string>{sources_.projectFile + ": it belongs to another user"});
}

TEST_F(LayersOf, LinksOfOthersAreNotFollowed) {
  const std::string mine = file("mine.toml", "report = \"/mine.json\"\n");
  sources_.projectFile = (folder_ / "link.toml").string();
  std::filesystem::create_symlink(mine, sources_.projectFile);
  EXPECT_NE(read("report"), "");
  constexpr uid_t kNobody = 65534;
  if (lchown(sources_.projectFile.c_str(), kNobody, getegid()) != 0)
    GTEST_SKIP() << "only root gives links away";
  EXPECT_EQ(read("report"), "");
  EXPECT_EQ(g_layerComplaints.size(), 1u);
}

TEST_F(LayersOf, SourcesOfTheProcess) {
  setenv("GLURAY_PROJECT", "/p/gluray.toml", 1);
  setenv("GLURAY_PROGRAM", "typed.py", 1);
  setenv("GLURAY_PID", std::to_string(getpid()).c_str(), 1);
  setenv("GLURAY_COMMAND_LINE", "spp=4\nlog=/a=b\n", 1);
  const Sources launched = sourcesOfProcess();
  setenv("GLURAY_PID", "1", 1);
  const Sources child = sourcesOfProcess();
  for (const char* name : {"GLURAY_PROJECT", "GLURAY_PROGRAM", "GLURAY_PID", "GLURAY_COMMAND_LINE"})
    unsetenv(name);
  const Sources alone = sourcesOfProcess();
  EXPECT_EQ(launched.projectFile, "/p/gluray.toml");
  EXPECT_EQ(launched.programs, (std::vector<std::string>{"settings_tests", "typed.py"}));
  EXPECT_EQ(launched.commandLine, (decltype(launched.commandLine){{"spp", "4"}, {"log", "/a=b"}}));
  EXPECT_EQ(child.programs, std::vector<std::string>{"settings_tests"});
  EXPECT_EQ(alone.projectFile, std::filesystem::current_path() / "gluray.toml");
  EXPECT_TRUE(alone.commandLine.empty());
  EXPECT_EQ(alone.systemFile, "/etc/gluray/gluray.toml");
}

}  // namespace
}  // namespace gluray
