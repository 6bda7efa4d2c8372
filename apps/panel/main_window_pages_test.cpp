// The window with a program that answers: what its pages and plots show, and how they are reached. Leaves
// images where GLURAY_PICTURES names a folder.
#include "pages/film/film_dialog.h"
#include "pages/objects/objects_page.h"
#include "testing/window_tools_fixture.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>
#include <QTreeWidget>
#include <set>

namespace gluray::panel {
namespace {

using nlohmann::json;

QPalette darkPalette() {
  QPalette dark(QColor(45, 45, 48), QColor(45, 45, 48));
  dark.setColor(QPalette::Base, QColor(30, 30, 30));
  dark.setColor(QPalette::Highlight, QColor(70, 140, 220));
  return dark;
}

TEST_F(WindowToolsTest, NoiseIsPlottedWhereThereIsSome) {
  auto* plot = window.findChild<QWidget*>("noise-plot");
  EXPECT_FALSE(plot->isVisible());
  program.state({{"noise", nullptr}, {"passes", nullptr}});
  EXPECT_FALSE(plot->isVisible());
  for (int i = 1; i < 200; ++i) program.state({{"noise", 0.2 / i}, {"passes", i % 100}});
  EXPECT_TRUE(plot->isVisible());
  EXPECT_EQ(program.controls.shown()->noise.size(), 201u);
  program.state({{"noise", "much"}, {"passes", -1e300}});
  image(window, "noise");
  plot->grab();
}

TEST_F(WindowToolsTest, TheWhyPageKeepsItsSelection) {
  open("Why");
  program.state({{"reasons", {{"lines with a width", 12}, {"points", 3}}}});
  auto* reasons = tabs().currentWidget()->findChild<QTreeWidget*>();
  ASSERT_EQ(reasons->topLevelItemCount(), 2);
  reasons->setCurrentItem(reasons->topLevelItem(1));
  program.state({{"reasons", {{"a new one", 1}, {"lines with a width", 13}, {"points", 4}}}});
  ASSERT_EQ(reasons->topLevelItemCount(), 3);
  ASSERT_NE(reasons->currentItem(), nullptr);
  EXPECT_EQ(reasons->currentItem()->text(0), "points");
  EXPECT_EQ(reasons->currentItem()->text(1), "4");
  EXPECT_TRUE(reasons->currentItem()->isSelected());
}

TEST_F(WindowToolsTest, HeadingsAndLabelsDoNotRepeatNames) {
  for (QGroupBox* box : window.findChildren<QGroupBox*>())
    for (QLabel* label : box->findChildren<QLabel*>())
      if (!label->text().isEmpty()) { EXPECT_NE(label->text(), box->title()); }
}

TEST_F(WindowToolsTest, EverythingHasANameAndCanBeReachedByTab) {
  open("Objects");
  ASSERT_TRUE(program.until([&] { return tabs().currentWidget()->findChild<QTableView*>()->isVisible(); }));
  window.findChild<ObjectsPage*>()->select(2);
  std::set<const QWidget*> reached;
  const QWidget* at = &window;
  for (int i = 0; i < 3000; ++i, at = at->nextInFocusChain()) reached.insert(at);
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()) continue;
    EXPECT_TRUE(reached.contains(widget)) << widget->metaObject()->className();
    const QAccessibleInterface* access = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(access, nullptr);
    const auto* parent = widget->parentWidget();
    const bool inside = qobject_cast<const QComboBox*>(parent) || parent->inherits("QAbstractSpinBox");
    if (!inside && !widget->inherits("QScrollArea") && !widget->inherits("QTabBar")) {
      EXPECT_FALSE(access->text(QAccessible::Name).isEmpty())
          << widget->metaObject()->className() << " " << widget->objectName().toStdString();
    }
  }
}

TEST_F(WindowToolsTest, SearchCountsObjectsAndStaysOnTheirPage) {
  open("Objects");
  ASSERT_TRUE(program.until([&] { return tabs().currentWidget()->findChild<QTableView*>()->isVisible(); }));
  window.findChild<QLineEdit*>("search")->setText("glass");
  EXPECT_EQ(tabs().tabText(tabs().currentIndex()), "Objects (1)");
  window.findChild<QLineEdit*>("search")->clear();
  EXPECT_EQ(tabs().tabText(tabs().currentIndex()), "Objects");
}

TEST_F(WindowToolsTest, ImagesOfADarkDesktop) {
  const QPalette before = QApplication::palette();
  QApplication::setPalette(darkPalette());
  for (int i = 0; i < 100; ++i) program.state({{"noise", 0.3 / (i + 1)}, {"passes", i}, {"fps", 20 + i % 7}});
  for (const char* title : {"Light", "Objects", "Why"}) {
    open(title);
    QTest::qWait(50);
    window.findChild<ObjectsPage*>()->select(2);
    image(window, ("dark-" + std::string(title)).c_str());
  }
  const QImage drawn = window.findChild<QWidget*>("fps-plot")->grab().toImage();
  EXPECT_EQ(drawn.pixelColor(drawn.width() / 2, drawn.height() / 2), QColor(30, 30, 30)) << "no white boxes";
  QApplication::setPalette(before);
}

TEST_F(WindowToolsTest, Images) {
  for (int i = 0; i < 100; ++i) program.state({{"noise", 0.3 / (i + 1)}, {"passes", i}, {"fps", 20 + i % 7}});
  program.say("lights", "headlight+key");
  QTest::qWait(50);
  for (const char* title : {"Quality", "Speed", "Light", "Shadows", "Occlusion", "Materials", "Objects",
                            "Camera", "Background"}) {
    open(title);
    QTest::qWait(20);
    window.findChild<ObjectsPage*>()->select(4);
    image(window, ("page-" + std::string(title)).c_str());
  }
  window.findChild<QAbstractButton*>("tool-compare")->click();
  ASSERT_TRUE(program.until([&] { return program.calls("pixels").size() == 3; }));
  QTest::qWait(20);
  image(window, "compare");
  FilmDialog dialog(program.controls, &window);
  dialog.show();
  image(dialog, "film");
}

}  // namespace
}  // namespace gluray::panel
