// The window with a program that answers: its tools, files that are dropped, and its end.
// main_window_pages_test.cpp has its pages.
#include "model/finish_changes.h"
#include "pages/film/film_dialog.h"
#include "pages/live/live_view.h"
#include "pages/live/live_window.h"
#include "pages/objects/objects_page.h"
#include "testing/window_tools_fixture.h"

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QMimeData>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

namespace gluray::panel {
namespace {

using nlohmann::json;

TEST_F(WindowToolsTest, AClickInTheImageSelectsTheObject) {
  program.values["pick"] = {{"object", 4}, {"position", {1, 2, 3}}, {"distance", 7}};
  LiveImage& image_ = live().liveImage();
  QTest::mouseClick(&image_, Qt::LeftButton, {}, image_.imageRect().center().toPoint());
  auto* page = window.findChild<ObjectsPage*>();
  ASSERT_TRUE(program.until([&] { return page->isVisible(); }));
  auto* table = page->findChild<QTableView*>();
  ASSERT_TRUE(program.until([&] { return table->selectionModel()->selectedRows().size() == 1; }));
  EXPECT_EQ(table->selectionModel()->selectedRows()[0].data(), "4");
  EXPECT_EQ(status(), "Object 4 at 1, 2, 3, distance 7");
  image(window, "objects");
  program.values["pick"] = {{"object", nullptr}};
  QTest::mouseClick(&image_, Qt::LeftButton, {}, image_.imageRect().center().toPoint());
  ASSERT_TRUE(program.until([&] { return table->selectionModel()->selectedRows().isEmpty(); }));
  EXPECT_EQ(status(), "There is no traced object at this point.");
}

TEST_F(WindowToolsTest, ALineOfAToolStaysWhenARequestIsCarriedOut) {
  program.values["pick"] = {{"object", nullptr}};
  LiveImage& image_ = live().liveImage();
  QTest::mouseClick(&image_, Qt::LeftButton, {}, image_.imageRect().center().toPoint());
  ASSERT_TRUE(program.until([&] { return status().startsWith("There is no"); }));
  program.controls.set("ao", true);
  program.settle();
  EXPECT_TRUE(status().startsWith("There is no"));
  program.controls.set("ao", true);
  program.receiveMessage({{"type", "answer"}, {"id", program.sent.back()["id"]}, {"why", "it is busy"}});
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

TEST_F(WindowToolsTest, KeysChooseTools) {
  window.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window));
  live().liveImage().setFocus();
  QTest::keyClick(&live().liveImage(), Qt::Key_L);
  EXPECT_TRUE(program.until([&] { return window.findChild<QAbstractButton*>("tool-light")->isChecked(); }));
  QTest::keyClick(&live().liveImage(), Qt::Key_F);
  EXPECT_TRUE(program.until([&] { return window.findChild<QAbstractButton*>("tool-focus")->isChecked(); }));
  auto* search = window.findChild<QLineEdit*>("search");
  search->setFocus();
  QTest::keyClicks(search, "fl");
  EXPECT_EQ(search->text(), "fl");
  EXPECT_TRUE(window.findChild<QAbstractButton*>("tool-focus")->isChecked());
}

TEST_F(WindowToolsTest, ADoubleClickOpensALargeWindow) {
  LiveImage& image_ = live().liveImage();
  QTest::mouseDClick(&image_, Qt::LeftButton, {}, image_.imageRect().center().toPoint());
  auto* large = window.findChild<LiveWindow*>();
  ASSERT_NE(large, nullptr);
  EXPECT_TRUE(large->isVisible());
  program.values["pick"] = {{"object", 3}};
  LiveImage& second = large->view().liveImage();
  QTest::mouseClick(&second, Qt::LeftButton, {}, second.imageRect().center().toPoint());
  ASSERT_TRUE(program.until([&] { return status() == "Object 3"; }));
  image(*large, "large");
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
  EXPECT_TRUE(program.calls("pixels").empty()) << "nobody sees the image";
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
  setting->setCurrentIndex(setting->findData("spp"));
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

}  // namespace
}  // namespace gluray::panel
