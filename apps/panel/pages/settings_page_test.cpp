#include "pages/settings_page.h"

#include "editors/editor.h"
#include "testing/fake_program.h"
#include "testing/reveal.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <memory>

namespace gluray::panel {
namespace {

/// The page of a group.
Page pageOf(std::string_view group) {
  for (const Page& page : pages())
    if (page.title == group) return page;
  ADD_FAILURE() << group;
  return {};
}

struct SettingsPageTest : testing::Test {
  SettingsPageTest() { program.appear(); }
  /// A page as a new run of the panel shows it.
  SettingsPage& show(std::string_view group) {
    page = std::make_unique<SettingsPage>(pageOf(group), program.controls, nullptr);
    page->show();
    page->update();
    return *page;
  }
  bool shows(const char* setting) { return page->findChild<Editor*>(setting)->isVisible(); }
  QToolButton& more() { return *page->findChild<QToolButton*>("more"); }

  OwnMemory memory;
  FakeProgram program;
  std::unique_ptr<SettingsPage> page;
};

TEST_F(SettingsPageTest, ShowsBasicSettingsUntilMoreAreWanted) {
  show("Occlusion");
  EXPECT_TRUE(shows("ao"));
  EXPECT_TRUE(shows("ao.radius"));
  EXPECT_FALSE(shows("ao.samples"));
  EXPECT_FALSE(shows("ao.on"));
  EXPECT_EQ(more().text(), "More settings (5)");
  more().click();
  EXPECT_TRUE(shows("ao"));
  EXPECT_TRUE(shows("ao.samples"));
  EXPECT_TRUE(shows("ao.on"));
  more().click();
  EXPECT_FALSE(shows("ao.samples"));
}

TEST_F(SettingsPageTest, RemembersWhetherMoreIsShown) {
  show("Occlusion");
  more().click();
  show("Shadows");
  EXPECT_FALSE(shows("shadows.samples")) << "each page has its own state";
  show("Occlusion");
  EXPECT_TRUE(shows("ao.samples"));
  more().click();
  show("Occlusion");
  EXPECT_FALSE(shows("ao.samples"));
}

TEST_F(SettingsPageTest, WithoutBasicSettingsShowsAll) {
  show("Diagnosis");
  EXPECT_EQ(page->findChild<QToolButton*>("more"), nullptr);
  EXPECT_TRUE(shows("quirks"));
}

TEST_F(SettingsPageTest, FiltersLookAtAllLevels) {
  show("Occlusion");
  EXPECT_EQ(page->filter("occlusion rays", false), 1);
  EXPECT_TRUE(shows("ao.samples"));
  EXPECT_FALSE(shows("ao"));
  EXPECT_FALSE(more().isVisible());
  EXPECT_EQ(page->filter("ao.samples", false), 1) << "by its name";
  program.say("ao.strength", 0.5);
  page->update();
  EXPECT_EQ(page->filter("", true), 1);
  EXPECT_TRUE(shows("ao.strength"));
  EXPECT_EQ(page->filter("", false), 7);
  EXPECT_TRUE(shows("ao"));
  EXPECT_FALSE(shows("ao.strength"));
  EXPECT_TRUE(more().isVisible());
}

TEST_F(SettingsPageTest, RowsHaveTitlesAndTheirNamesInTooltips) {
  show("Occlusion");
  int rows = 0;
  for (const SettingRow* row : page->findChildren<SettingRow*>()) {
    EXPECT_EQ(row->label()->text(), QString::fromUtf8(row->row().title.data()));
    EXPECT_TRUE(row->label()->toolTip().contains(QString::fromUtf8(row->row().name.data())));
    EXPECT_TRUE(row->label()->toolTip().contains(QString::fromUtf8(row->row().help.data()).toHtmlEscaped()));
    ++rows;
  }
  EXPECT_EQ(rows, 7);
}

}  // namespace
}  // namespace gluray::panel
