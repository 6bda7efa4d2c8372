#include "pages/layout.h"

#include <gtest/gtest.h>

#include <map>

namespace gluray::panel {
namespace {

TEST(Pages, HaveEverySettingOfRunningProgramsOnce) {
  std::map<std::string_view, int> times;
  for (const Page& page : pages())
    for (const Section& section : page.sections)
      for (const Row* row : section.rows) ++times[row->name];
  for (const Row& row : settingRows())
    EXPECT_EQ(times[row.name], row.applies == Applies::frame && row.name != "preset") << row.name;
}

TEST(Pages, AreGroupsInTheirOrder) {
  size_t group = 0;
  for (const Page& page : pages()) {
    while (group < settingGroups().size() && settingGroups()[group] != page.title) ++group;
    ASSERT_LT(group, settingGroups().size()) << page.title;
    for (const Section& section : page.sections)
      for (const Row* row : section.rows) EXPECT_EQ(row->group, page.title) << row->name;
  }
  EXPECT_EQ(pages()[0].title, "Quality");
}

TEST(Pages, BeginWithTheirBasicSettings) {
  for (const Page& page : pages())
    for (size_t i = 0; i < page.sections.size(); ++i) {
      const Section& section = page.sections[i];
      EXPECT_FALSE(section.rows.empty()) << page.title;
      if (i > 0) { EXPECT_LT(page.sections[i - 1].level, section.level) << page.title; }
      for (const Row* row : section.rows) EXPECT_EQ(row->level, section.level) << row->name;
    }
  EXPECT_EQ(pages()[0].sections[0].level, Level::basic);
}

TEST(Matches, LooksForEachWord) {
  const Row& row = *findSetting("ao.samples");
  EXPECT_TRUE(matches(row, ""));
  EXPECT_TRUE(matches(row, "AO.Sampl"));
  EXPECT_TRUE(matches(row, "occlusion RAYS"));
  EXPECT_FALSE(matches(row, "ao.samples zebra"));
}

TEST(Matches, FindsTitlesThatHelpDoesNotMention) {
  const Row& row = *findSetting("shadows.size");
  ASSERT_EQ(row.help.find("softness"), row.help.npos);
  EXPECT_TRUE(matches(row, "shadow softness"));
}

}  // namespace
}  // namespace gluray::panel
