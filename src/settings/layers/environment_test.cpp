#include "settings/settings.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace gluray {
namespace {

std::vector<std::string> g_variableComplaints;

/// The session with the given variables set and all others unset.
Session sessionOf(std::vector<std::pair<const char*, const char*>> variables) {
  setenv("XDG_CONFIG_HOME", "/nowhere", 1);
  for (const char* name :
       {"CONFIG", "THREADS", "ENGINE", "BVH", "SHADING", "RENDERER", "SPP", "OFF", "REPORT", "TIMELINE",
        "LOG", "LOG_LEVEL", "QUIRKS", "PROGRAM_FAMILIES", "EXPLAIN", "PICTURE"})
    unsetenv((std::string("GLURAY_") + name).c_str());
  for (const auto& [name, value] : variables) setenv(name, value, 1);
  g_variableComplaints.clear();
  return sessionFromEnvironment([](const std::string& line) { g_variableComplaints.push_back(line); });
}

TEST(Environment, NothingSetGivesDefaults) {
  const Session session = sessionOf({});
  EXPECT_EQ(session.settings, Settings{});
  EXPECT_FALSE(session.off);
  EXPECT_EQ(session.logLevel, LogLevel::warning);
  EXPECT_TRUE(session.reportFile.empty());
  EXPECT_TRUE(g_variableComplaints.empty());
}

TEST(Environment, RanksOfAHostShareItsCores) {
  EXPECT_EQ(threadsOfRank(8, 8, 1), 0);  // a single rank: all cores
  EXPECT_EQ(threadsOfRank(8, 8, 2), 4);
  EXPECT_EQ(threadsOfRank(8, 8, 3), 2);
  EXPECT_EQ(threadsOfRank(2, 2, 4), 1);  // at least one
  EXPECT_EQ(threadsOfRank(8, 2, 4), 0);  // already bound to its own cores
}

TEST(Environment, ARankTakesItsShareUnlessThreadsAreSet) {
  setenv("OMPI_COMM_WORLD_LOCAL_SIZE", "1000000", 1);
  const int share = sessionOf({}).settings.threads,
            set = sessionOf({{"GLURAY_THREADS", "3"}}).settings.threads;
  unsetenv("OMPI_COMM_WORLD_LOCAL_SIZE");
  EXPECT_LE(share, 1);
  EXPECT_EQ(set, 3);
}

TEST(Environment, EveryVariableIsRead) {
  const Session session = sessionOf({{"GLURAY_THREADS", "3"},
                                     {"GLURAY_ENGINE", "always"},
                                     {"GLURAY_BVH", "compact"},
                                     {"GLURAY_SHADING", "vertex"},
                                     {"GLURAY_RENDERER", "null"},
                                     {"GLURAY_SPP", "16"},
                                     {"GLURAY_LAG", "auto"},
                                     {"GLURAY_HUD", "1"},
                                     {"GLURAY_OFF", "1"},
                                     {"GLURAY_REPORT", "/r.json"},
                                     {"GLURAY_TIMELINE", "/t.json"},
                                     {"GLURAY_LOG", "/l.txt"},
                                     {"GLURAY_LOG_LEVEL", "debug"},
                                     {"GLURAY_QUIRKS", "material-latch=off"},
                                     {"GLURAY_PROGRAM_FAMILIES", "/a.toml:/b.toml"},
                                     {"GLURAY_EXPLAIN", "100"},
                                     {"GLURAY_PICTURE", "1"}});
  EXPECT_EQ(session.settings.threads, 3);
  EXPECT_EQ(session.settings.engine, Engine::always);
  EXPECT_EQ(session.settings.bvh, BvhQuality::compact);
  EXPECT_EQ(session.settings.shading, ShadingRate::vertex);
  EXPECT_EQ(session.settings.renderer, Renderer::null);
  EXPECT_EQ(session.settings.spp, 16);
  EXPECT_TRUE(session.off);
  EXPECT_EQ(session.lag, LagMode::automatic);
  EXPECT_TRUE(session.hud);
  EXPECT_EQ(session.reportFile, "/r.json");
  EXPECT_EQ(session.timelineFile, "/t.json");
  EXPECT_EQ(session.logFile, "/l.txt");
  EXPECT_EQ(session.logLevel, LogLevel::debug);
  EXPECT_FALSE(session.settings.quirks.has(Quirk::materialLatch));
  EXPECT_EQ(session.programFamilies, (std::vector<std::string>{"/a.toml", "/b.toml"}));
  EXPECT_EQ(session.explainFrames, 100);
  EXPECT_TRUE(session.picture);
  EXPECT_TRUE(g_variableComplaints.empty());
}

TEST(Environment, EveryEngineHasAWord) {
  EXPECT_EQ(Settings{}.engine, Engine::automatic);
  EXPECT_EQ(sessionOf({{"GLURAY_ENGINE", "auto"}}).settings.engine, Engine::automatic);
  EXPECT_EQ(sessionOf({{"GLURAY_ENGINE", "never"}}).settings.engine, Engine::never);
  EXPECT_TRUE(g_variableComplaints.empty());
}

TEST(Environment, EveryBvhQualityHasAWord) {
  EXPECT_EQ(Settings{}.bvh, BvhQuality::automatic);
  EXPECT_EQ(sessionOf({{"GLURAY_BVH", "auto"}}).settings.bvh, BvhQuality::automatic);
  EXPECT_EQ(sessionOf({{"GLURAY_BVH", "fast"}}).settings.bvh, BvhQuality::fast);
  EXPECT_EQ(sessionOf({{"GLURAY_BVH", "full"}}).settings.bvh, BvhQuality::full);
  EXPECT_EQ(sessionOf({{"GLURAY_BVH", "least"}}).settings.bvh, BvhQuality::least);
  EXPECT_TRUE(g_variableComplaints.empty());
}

TEST(Environment, UnreadableValuesAreReportedAndKeepTheirDefaults) {
  const Session session =
      sessionOf({{"GLURAY_THREADS", "many"}, {"GLURAY_BVH", "quick"}, {"GLURAY_LOG_LEVEL", "loud"}});
  EXPECT_EQ(session.settings, Settings{});
  EXPECT_EQ(session.logLevel, LogLevel::warning);
  ASSERT_EQ(g_variableComplaints.size(), 3u);
  EXPECT_EQ(g_variableComplaints[0], "GLURAY_THREADS=many: use a number from 0 (all cores) to 1024 threads");
  EXPECT_EQ(g_variableComplaints[1], "GLURAY_BVH=quick: use auto, fast, full, compact or least");
  EXPECT_EQ(g_variableComplaints[2], "GLURAY_LOG_LEVEL=loud: use trace, debug, info, warning, error or off");
}

TEST(Environment, NegativeAndAbsurdThreadCountsAreRefused) {
  EXPECT_EQ(sessionOf({{"GLURAY_THREADS", "-1"}}).settings.threads, 0);
  EXPECT_EQ(g_variableComplaints.size(), 1u);
  EXPECT_EQ(sessionOf({{"GLURAY_THREADS", "99999999999999999999"}}).settings.threads, 0);
  EXPECT_EQ(g_variableComplaints.size(), 1u);
}

}  // namespace
}  // namespace gluray
