#include "settings/layers/config_file.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gluray {
namespace {

std::vector<std::string> g_fileComplaints;

class ConfigFileTest : public testing::Test {
 protected:
  ConfigFileTest() : folder_(testing::TempDir() + "gluray-config-" + std::to_string(getpid())) {
    std::filesystem::create_directories(folder_ / "gluray");
    for (const char* name : {"GLURAY_CONFIG", "GLURAY_BVH", "GLURAY_THREADS"}) unsetenv(name);
    setenv("XDG_CONFIG_HOME", folder_.c_str(), 1);
    g_fileComplaints.clear();
  }
  ~ConfigFileTest() override { std::filesystem::remove_all(folder_); }

  std::string file() const { return (folder_ / "gluray/gluray.toml").string(); }
  Session sessionOf(const std::string& text) {
    std::ofstream(file()) << text;
    return sessionFromEnvironment([](const std::string& line) { g_fileComplaints.push_back(line); });
  }
  std::filesystem::path folder_;
};

TEST_F(ConfigFileTest, EverySettingIsRead) {
  const Session session = sessionOf(R"(
# four threads, least memory
threads = 4
bvh = "compact"
shading = "vertex"
renderer = "null"
off = true
report = "/r.json"
log = "/l.txt"
log-level = "debug"
quirks = "material-latch=off"
program-families = "/a.toml:/b.toml"
)");
  EXPECT_EQ(g_fileComplaints, std::vector<std::string>{});
  EXPECT_EQ(session.settings.threads, 4);
  EXPECT_EQ(session.settings.bvh, BvhQuality::compact);
  EXPECT_EQ(session.settings.shading, ShadingRate::vertex);
  EXPECT_EQ(session.settings.renderer, Renderer::null);
  EXPECT_TRUE(session.off);
  EXPECT_EQ(session.reportFile, "/r.json");
  EXPECT_EQ(session.logFile, "/l.txt");
  EXPECT_EQ(session.logLevel, LogLevel::debug);
  EXPECT_FALSE(session.settings.quirks.has(Quirk::materialLatch));
  EXPECT_EQ(session.programFamilies, (std::vector<std::string>{"/a.toml", "/b.toml"}));
}

TEST_F(ConfigFileTest, SwitchesOfGroupsStandInTheirTables) {
  EXPECT_TRUE(sessionOf("ao = true").settings.ao.enabled);
  EXPECT_TRUE(sessionOf("ao = \"on\"").settings.ao.enabled);
  const Session session = sessionOf("[ao]\nenabled = true\nsamples = 64\n");
  EXPECT_TRUE(session.settings.ao.enabled);
  EXPECT_EQ(session.settings.ao.samples, 64);
  EXPECT_EQ(g_fileComplaints, std::vector<std::string>{});
  EXPECT_FALSE(sessionOf("[threads]\nenabled = 4\n").settings.ao.enabled);
  EXPECT_EQ(g_fileComplaints.size(), 1u) << "threads heads no group";
}

TEST_F(ConfigFileTest, ListsMayBeArrays) {
  const Session session = sessionOf("program-families = [\"/a.toml\", \"/b.toml\"]\nlog = [\"/l\"]\n");
  EXPECT_EQ(session.programFamilies, (std::vector<std::string>{"/a.toml", "/b.toml"}));
  EXPECT_EQ(g_fileComplaints,
            std::vector<std::string>{file() + ":2: log: use a string, a whole number, true or false"});
}

TEST_F(ConfigFileTest, UnknownNamesAreReportedWithTheNearest) {
  sessionOf("bhv = \"fast\"\n[display]\nbvh = \"fast\"\n");
  ASSERT_EQ(g_fileComplaints.size(), 2u);
  EXPECT_EQ(g_fileComplaints[0], file() + ":1: no setting is called 'bhv'; did you mean 'bvh'?");
  EXPECT_EQ(g_fileComplaints[1], file() + ":2: no setting is called 'display'");
}

TEST_F(ConfigFileTest, FractionsAreReportedWithTheRange) {
  EXPECT_EQ(sessionOf("spp = 1.5\n").settings.spp, 1);
  EXPECT_EQ(g_fileComplaints,
            std::vector<std::string>{file() + ":1: spp = 1.5: use a number from 1 (the centre) to 1024"});
}

TEST_F(ConfigFileTest, TheEnvironmentOverridesIt) {
  setenv("GLURAY_BVH", "fast", 1);
  const Session session = sessionOf("bvh = \"full\"\nthreads = 2\n");
  unsetenv("GLURAY_BVH");
  EXPECT_EQ(session.settings.bvh, BvhQuality::fast);
  EXPECT_EQ(session.settings.threads, 2);
}

TEST_F(ConfigFileTest, WrongLinesAreReportedWithTheirNumberAndOthersApply) {
  const Session session =
      sessionOf("threads = 2\nbvh = \"quick\"\nexplain = 1\nshading = [1]\noff = \"maybe\"\n");
  EXPECT_EQ(session.settings.threads, 2);
  EXPECT_EQ(session.settings.bvh, BvhQuality::automatic);
  ASSERT_EQ(g_fileComplaints.size(), 4u);
  const auto told = [](const std::string& line) {
    return std::find(g_fileComplaints.begin(), g_fileComplaints.end(), line) != g_fileComplaints.end();
  };
  EXPECT_TRUE(told(file() + ":2: bvh = quick: use auto, fast, full, compact or least"));
  EXPECT_TRUE(told(file() + ":3: no setting is called 'explain'"));
  EXPECT_TRUE(told(file() + ":4: shading: use a string, a whole number, true or false"));
  EXPECT_TRUE(told(file() + ":5: off = maybe: use on, off, true, false, 1 or 0"));
}

TEST_F(ConfigFileTest, UnparsableFilesAreReportedInOneLine) {
  const Session session = sessionOf("threads = 2\nbvh = = 3\n");
  EXPECT_EQ(session.settings, Settings{});
  ASSERT_EQ(g_fileComplaints.size(), 1u);
  EXPECT_EQ(g_fileComplaints[0].rfind(file() + ":2: ", 0), 0u) << g_fileComplaints[0];
}

TEST_F(ConfigFileTest, OnlyMissingNamedFilesAreReported) {
  const auto read = [] {
    return sessionFromEnvironment([](const std::string& l) { g_fileComplaints.push_back(l); });
  };
  EXPECT_EQ(read().settings, Settings{});
  EXPECT_TRUE(g_fileComplaints.empty());
  setenv("GLURAY_CONFIG", "/nowhere/gluray.toml", 1);
  EXPECT_EQ(read().settings, Settings{});
  unsetenv("GLURAY_CONFIG");
  ASSERT_EQ(g_fileComplaints.size(), 1u);
  EXPECT_EQ(g_fileComplaints[0], "/nowhere/gluray.toml: No such file or directory");
  setenv("GLURAY_CONFIG", folder_.c_str(), 1);
  EXPECT_EQ(read().settings, Settings{});
  unsetenv("GLURAY_CONFIG");
  ASSERT_EQ(g_fileComplaints.size(), 2u);
  EXPECT_EQ(g_fileComplaints[1], folder_.string() + ": Is a directory");
}

}  // namespace
}  // namespace gluray
