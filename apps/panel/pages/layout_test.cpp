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

TEST(Pages, BeginWithTheirFixedOrder) {
  const std::vector<Page> all = pages();
  ASSERT_GE(all.size(), 6u);
  EXPECT_EQ(all[0].title, "Light");
  EXPECT_EQ(all[0].sections[0].word, "ao");
  EXPECT_EQ(all[5].title, "Image");
}

TEST(Matches, LooksForEachWord) {
  const Row& row = *findSetting("ao.samples");
  EXPECT_TRUE(matches(row, ""));
  EXPECT_TRUE(matches(row, "AO Sampl"));
  EXPECT_FALSE(matches(row, "ao zebra"));
}

}  // namespace
}  // namespace gluray::panel
