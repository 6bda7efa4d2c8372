// The window with a program that answers: what the parts do together. Leaves pictures where GLURAY_PICTURES
// names a folder.
#include "main_window.h"
#include "model/finish_changes.h"
#include "pages/film/film_dialog.h"
#include "pages/live/live_view.h"
#include "pages/live/live_window.h"
#include "pages/objects/objects_page.h"
#include "testing/fake_program.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QSlider>
#include <QStatusBar>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <cstdlib>
#include <set>

namespace gluray::panel {
namespace {

using nlohmann::json;

struct WindowToolsTest : testing::Test {
  void SetUp() override {
    program.values["objects"] = fakeObjects(30);
    program.values["objects"]["objects"][1] = fakeObject(2, "#3366cc", "glass");
    program.values["objects"]["objects"][3] = fakeObject(4, nullptr, "metal");
    program.values["objects"]["objects"][3]["hidden"] = {"camera", "shadow"};
    program.values["lights"] = {{"lights",
                                 {{{"name", "key"},
                                   {"from", "rig"},
                                   {"kind", "directional"},
                                   {"azimuth", 45},
                                   {"elevation", 35},
                                   {"color", "#fff4e0"},
                                   {"strength", 0.714}},
                                  {{"name", "fill"},
                                   {"from", "rig"},
                                   {"kind", "directional"},
                                   {"azimuth", 0},
                                   {"elevation", 0},
                                   {"color", "#ffffff"},
                                   {"strength", 0.286}}}}};
    program.appear();
    window.show();
  }
  QTabWidget& tabs() { return *window.findChild<QTabWidget*>(); }
  void open(const QString& title) {
    for (int i = 0; i < tabs().count(); ++i)
      if (tabs().tabText(i) == title) tabs().setCurrentIndex(i);
    ASSERT_EQ(tabs().tabText(tabs().currentIndex()), title);
  }
  QString status() { return window.statusBar()->currentMessage(); }
  LiveView& live() { return *window.findChild<LiveView*>(); }
  void drop(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent event({50, 50}, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &event);
  }
  static void picture(QWidget& widget, const char* name) {
    if (const char* folder = std::getenv("GLURAY_PICTURES"))
      widget.grab().save(QString("%1/%2.png").arg(folder, name));
  }

  FakeProgram program;
  MainWindow window{program.controls};
};

TEST_F(WindowToolsTest, AClickInThePictureSelectsTheObject) {
  program.values["pick"] = {{"object", 4}, {"position", {1, 2, 3}}, {"distance", 7}};
  LivePicture& picture_ = live().picture();
  QTest::mouseClick(&picture_, Qt::LeftButton, {}, picture_.pictureRect().center().toPoint());
  auto* page = window.findChild<ObjectsPage*>();
  ASSERT_TRUE(program.until([&] { return page->isVisible(); }));
  auto* table = page->findChild<QTableView*>();
  ASSERT_TRUE(program.until([&] { return table->selectionModel()->selectedRows().size() == 1; }));
  EXPECT_EQ(table->selectionModel()->selectedRows()[0].data(), "4");
  EXPECT_EQ(status(), "Object 4 at 1, 2, 3, distance 7");
  picture(window, "objects");
  program.values["pick"] = {{"object", nullptr}};
  QTest::mouseClick(&picture_, Qt::LeftButton, {}, picture_.pictureRect().center().toPoint());
  ASSERT_TRUE(program.until([&] { return table->selectionModel()->selectedRows().isEmpty(); }));
  EXPECT_EQ(status(), "Nothing that GLuRay traces is there.");
}

TEST_F(WindowToolsTest, ALineOfAToolStaysWhenARequestIsCarriedOut) {
  program.values["pick"] = {{"object", nullptr}};
  LivePicture& picture_ = live().picture();
  QTest::mouseClick(&picture_, Qt::LeftButton, {}, picture_.pictureRect().center().toPoint());
  ASSERT_TRUE(program.until([&] { return status().startsWith("Nothing"); }));
  program.controls.set("ao", true);
  program.settle();
  EXPECT_TRUE(status().startsWith("Nothing"));
  program.controls.set("ao", true);
  program.take({{"type", "answer"}, {"id", program.sent.back()["id"]}, {"why", "it is busy"}});
  EXPECT_EQ(status(), "it is busy");
}

TEST_F(WindowToolsTest, TakesFilesThatAreDropped) {
  const QTemporaryDir folder;
  const auto write = [&](const char* name, const char* text) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  };
  const auto sent = [&](const QString& file) {
    const size_t before = program.sets().size();
    drop(file);
    return program.sets().size() > before ? program.sets().back()["values"] : json();
  };
  const QString sky = write("sky.HDR", "#?RADIANCE"), room = write("room.exr", "v/1");
  EXPECT_EQ(sent(sky), json({{"environment", "image"}, {"environment.file", sky.toStdString()}}));
  EXPECT_EQ(sent(room)["environment.file"], room.toStdString());
  const QString rules = write("rules.toml", "# rules\n  [[rule]]\nobjects = [1]\n"),
                lights = write("lights.toml", "[[ light ]]\nkind = 'point'\n");
  EXPECT_EQ(sent(rules), json({{"material.file", rules.toStdString()}}));
  EXPECT_EQ(sent(lights), json({{"lights.file", lights.toStdString()}}));
  EXPECT_EQ(status(), "lights.file = " + lights);
  for (const QString& file : {write("a.toml", "[ao]\n"), write("b.toml", "[[rule]]\n[[light]]\n"),
                              write("c.png", ""), folder.filePath("missing.hdr"), folder.path()}) {
    EXPECT_TRUE(sent(file).is_null()) << file.toStdString();
    EXPECT_FALSE(status().isEmpty());
    EXPECT_FALSE(status().contains('\n'));
  }
  program.end();
  EXPECT_TRUE(sent(sky).is_null());
  EXPECT_EQ(status(), "Choose a program before you drop a file");
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
  picture(window, "noise");
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

TEST_F(WindowToolsTest, KeysChooseTools) {
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  live().picture().setFocus();
  QTest::keyClick(&live().picture(), Qt::Key_L);
  EXPECT_TRUE(program.until([&] { return window.findChild<QAbstractButton*>("tool-light")->isChecked(); }));
  QTest::keyClick(&live().picture(), Qt::Key_F);
  EXPECT_TRUE(program.until([&] { return window.findChild<QAbstractButton*>("tool-focus")->isChecked(); }));
  auto* search = window.findChild<QLineEdit*>("search");
  search->setFocus();
  QTest::keyClicks(search, "fl");
  EXPECT_EQ(search->text(), "fl");
  EXPECT_TRUE(window.findChild<QAbstractButton*>("tool-focus")->isChecked());
}

TEST_F(WindowToolsTest, ADoubleClickOpensALargeWindow) {
  LivePicture& picture_ = live().picture();
  QTest::mouseDClick(&picture_, Qt::LeftButton, {}, picture_.pictureRect().center().toPoint());
  auto* large = window.findChild<LiveWindow*>();
  ASSERT_NE(large, nullptr);
  EXPECT_TRUE(large->isVisible());
  program.values["pick"] = {{"object", 3}};
  LivePicture& second = large->view().picture();
  QTest::mouseClick(&second, Qt::LeftButton, {}, second.pictureRect().center().toPoint());
  ASSERT_TRUE(program.until([&] { return status() == "Object 3"; }));
  picture(*large, "large");
}

TEST_F(WindowToolsTest, SearchCountsObjectsAndStaysOnTheirPage) {
  open("Objects");
  ASSERT_TRUE(program.until([&] { return tabs().currentWidget()->findChild<QTableView*>()->isVisible(); }));
  window.findChild<QLineEdit*>("search")->setText("glass");
  EXPECT_EQ(tabs().tabText(tabs().currentIndex()), "Objects (1)");
  window.findChild<QLineEdit*>("search")->clear();
  EXPECT_EQ(tabs().tabText(tabs().currentIndex()), "Objects");
}

TEST_F(WindowToolsTest, ClosingWaitsForTheComparison) {
  program.answers = false;
  window.findChild<QAbstractButton*>("tool-compare")->click();
  ASSERT_EQ(program.sent.back()["type"], "batch");
  const json batch = program.sent.back();
  window.close();
  EXPECT_FALSE(window.isVisible());
  EXPECT_TRUE(program.controls.isChanging());
  QTimer::singleShot(50, &window, [&] { program.answer(batch); });
  finishChanges(program.controls);
  EXPECT_EQ(program.sets().back()["values"], json({{"engine", nullptr}}));
  EXPECT_FALSE(program.controls.isChanging());
  EXPECT_TRUE(program.calls("pixels").empty()) << "nobody sees the picture";
  program.state({{"windows", {{{"width", 7}, {"height", 7}}}}});  // it does not compare any more
  const size_t before = program.sent.size();
  QTest::qWait(700);
  EXPECT_EQ(program.sent.size(), before);
}

TEST_F(WindowToolsTest, ClosingSetsBackWhatAFilmVaries) {
  const QTemporaryDir folder;
  program.say("spp", 4);
  window.findChild<QAbstractButton*>("film")->click();
  auto* dialog = window.findChild<FilmDialog*>();
  ASSERT_NE(dialog, nullptr);
  dialog->findChild<QLineEdit*>("film-folder")->setText(folder.path());
  auto* setting = dialog->findChild<QComboBox*>("film-setting");
  setting->setCurrentIndex(setting->findText("spp"));
  dialog->findChild<QAbstractButton*>("film-start")->click();
  ASSERT_TRUE(program.until([&] { return program.calls("shot").size() == 2; }));
  window.close();
  finishChanges(program.controls);
  EXPECT_FALSE(program.controls.isChanging());
  EXPECT_EQ(program.controls.value("spp").value, 4);
  EXPECT_EQ(program.sets().back()["values"], json({{"spp", 4}}));
}

TEST_F(WindowToolsTest, ClosingDoesNotWaitForever) {
  program.answers = false;
  window.findChild<QAbstractButton*>("tool-compare")->click();
  window.close();
  finishChanges(program.controls, std::chrono::milliseconds(20));
  EXPECT_TRUE(program.controls.isChanging());
  program.end();
  EXPECT_FALSE(program.controls.isChanging()) << "nobody is left to answer";
  finishChanges(program.controls);
}

QPalette darkPalette() {
  QPalette dark(QColor(45, 45, 48), QColor(45, 45, 48));
  dark.setColor(QPalette::Base, QColor(30, 30, 30));
  dark.setColor(QPalette::Highlight, QColor(70, 140, 220));
  return dark;
}

TEST_F(WindowToolsTest, PicturesOfADarkDesktop) {
  const QPalette before = QApplication::palette();
  QApplication::setPalette(darkPalette());
  for (int i = 0; i < 100; ++i) program.state({{"noise", 0.3 / (i + 1)}, {"passes", i}, {"fps", 20 + i % 7}});
  for (const char* title : {"Light", "Objects", "Why"}) {
    open(title);
    QTest::qWait(50);
    window.findChild<ObjectsPage*>()->select(2);
    picture(window, ("dark-" + std::string(title)).c_str());
  }
  const QImage drawn = window.findChild<QWidget*>("fps-plot")->grab().toImage();
  EXPECT_EQ(drawn.pixelColor(drawn.width() / 2, drawn.height() / 2), QColor(30, 30, 30)) << "no white boxes";
  QApplication::setPalette(before);
}

TEST_F(WindowToolsTest, Pictures) {
  for (int i = 0; i < 100; ++i) program.state({{"noise", 0.3 / (i + 1)}, {"passes", i}, {"fps", 20 + i % 7}});
  program.say("lights", "headlight+key");
  QTest::qWait(50);
  for (const char* title : {"Light", "Materials", "Objects", "Quality", "Speed", "Picture"}) {
    open(title);
    QTest::qWait(20);
    window.findChild<ObjectsPage*>()->select(4);
    picture(window, ("page-" + std::string(title)).c_str());
  }
  window.findChild<QAbstractButton*>("tool-compare")->click();
  ASSERT_TRUE(program.until([&] { return program.calls("pixels").size() == 3; }));
  QTest::qWait(20);
  picture(window, "compare");
  FilmDialog dialog(program.controls, &window);
  dialog.show();
  picture(dialog, "film");
}

}  // namespace
}  // namespace gluray::panel
