#include "settings/layers/profiles.h"

#include "settings/layers/settings_layers.h"
#include "settings/values.h"

#include <gtest/gtest.h>

#include <set>

namespace gluray {
namespace {

Layers layersFor(const std::string& program) {
  Sources sources;
  sources.programs = {program};
  sources.variables.emplace();
  return readLayers(sources, [](const std::string& line) { ADD_FAILURE() << line; });
}

TEST(ShippedProfiles, AreValidAndReachTheirProgramsByName) {
  std::set<std::string> programs;
  for (const FileSetting& s : shippedProfiles()) {
    EXPECT_EQ(s.section.kind, Section::Kind::program) << s.name;
    EXPECT_EQ(s.wrong, "") << s.section.name << ": " << s.name;
    programs.insert(s.section.name);
  }
  EXPECT_GT(programs.size(), 2u);
  for (const std::string& program : programs) {
    EXPECT_FALSE(shippedProfile(program).empty()) << program;
    EXPECT_FALSE(layersFor(program).given.empty()) << program;
  }
}

TEST(ShippedProfiles, SwitchNothingOn) {
  for (const FileSetting& s : shippedProfiles()) {
    const Settings settings = layersFor(s.section.name).session.settings;
    EXPECT_FALSE(settings.changesImage()) << s.section.name << ": " << s.name;
  }
}

TEST(ShippedProfiles, OtherProgramsHaveNone) {
  for (const char* name : {"", "glxgears", "openscad2", "openscad]\n[x", "program.openscad", "openscad\n"})
    EXPECT_TRUE(shippedProfile(name).empty()) << name;
}

TEST(ShippedProfiles, FilesOverrideThem) {
  const Row& up = *findSetting("lights.up");
  Sources sources;
  sources.programs = {"openscad", "scad"};
  sources.variables.emplace();
  ConfigFiles files;
  files[1] = {Layer::user, "/u/gluray.toml", readConfigText("[program.scad]\nlights.up = 'x'\n")};
  const auto fail = [](const std::string& line) { ADD_FAILURE() << line; };
  const Layers both = layersOf(sources, files, fail);
  EXPECT_EQ(printValue(up, both.session), "x");
  EXPECT_EQ(both.last(up)->place, "/u/gluray.toml:2");
  files[1] = {Layer::user, "/u/gluray.toml", readConfigText("lights.up = 'x'\n")};
  const Layers general = layersOf(sources, files, fail);
  EXPECT_EQ(printValue(up, general.session), "z");
  EXPECT_EQ(general.last(up)->layer, Layer::program);
  EXPECT_EQ(general.last(up)->place, "shipped");
}

}  // namespace
}  // namespace gluray
