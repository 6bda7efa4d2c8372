#include "main_window.h"

#include "control/messages/base64.h"
#include "pages/live/live_image.h"
#include "pages/program_list.h"
#include "testing/reveal.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSlider>
#include <QStatusBar>
#include <QTabWidget>
#include <QTest>
#include <cstdlib>

namespace gluray::panel {
namespace {

using nlohmann::json;

struct MainWindowTest : testing::Test {
  void take(const json& message) { controls.receiveMessage(std::make_shared<const json>(message)); }
  void SetUp() override { window.show(); }
  void appear() {
    take({{"type", "event"},
          {"what", "programs"},
          {"programs",
           {{{"program", 1}, {"pid", 4242}, {"name", "paraview"}, {"host", "here"}, {"ranks", 1}}}}});
    take({{"type", "event"},
          {"what", "settings"},
          {"program", 1},
          {"values", {{"ao", {{"value", true}, {"layer", "live"}, {"place", ""}}}}},
          {"undo", 2},
          {"redo", 0}});
    for (int i = 0; i < 200; ++i)
      take({{"type", "event"},
            {"what", "state"},
            {"program", 1},
            {"state",
             {{"fps", 20 + i % 7},
              {"triangles", 1234567},
              {"traced", 0.98},
              {"reasons", {{"lines with a width", 12}}},
              {"warnings", {"a warning"}}}}});
    show(64, 48);
  }
  /// A thumbnail arrives, the left half of which is red, the right one blue.
  void show(int width, int height) {
    std::string bytes;
    for (int i = 0; i < width * height; ++i)
      bytes += i % width < width / 2 ? std::string("\xff\0\0", 3) : std::string("\0\0\xff", 3);
    take({{"type", "event"},
          {"what", "thumbnail"},
          {"program", 1},
          {"width", width},
          {"height", height},
          {"pixels", control::toBase64(bytes)}});
  }
  /// Saves an image where GLURAY_PICTURES names a folder.
  void image(const char* name) {
    if (const char* folder = std::getenv("GLURAY_PICTURES"))
      window.grab().save(QString("%1/%2.png").arg(folder, name));
  }
  QWidget* setting(const char* name) { return window.findChild<QWidget*>(name); }

  std::vector<json> sent;
  Controls controls{[this](json message) { sent.push_back(std::move(message)); }};
  MainWindow window{controls};
};

TEST_F(MainWindowTest, SaysThatThereIsNoProgram) {
  EXPECT_EQ(window.statusBar()->currentMessage(),
            "No program runs under GLuRay; start one with: gluray PROGRAM");
  EXPECT_FALSE(setting("ao")->isEnabled());
  image("panel-empty");
}

TEST_F(MainWindowTest, AsksForAChoiceAmongSeveralPrograms) {
  take({{"type", "event"},
        {"what", "programs"},
        {"programs",
         {{{"program", 1}, {"pid", 1}, {"name", "a"}}, {{"program", 2}, {"pid", 2}, {"name", "b"}}}}});
  EXPECT_EQ(window.statusBar()->currentMessage(), "Choose a program on the left");
  EXPECT_FALSE(setting("ao")->isEnabled());
  controls.choose(2);
  EXPECT_EQ(window.statusBar()->currentMessage(), "");
  EXPECT_TRUE(setting("ao")->isEnabled());
}

TEST_F(MainWindowTest, ShowsAProgramsValues) {
  appear();
  EXPECT_TRUE(setting("ao")->isEnabled());
  EXPECT_TRUE(window.findChild<QTabWidget*>());
  image("panel-light");
  window.findChild<QTabWidget*>()->setCurrentIndex(window.findChild<QTabWidget*>()->count() - 1);
  image("panel-why");
}

TEST_F(MainWindowTest, ShowsTheImageOfAProgram) {
  appear();
  const auto colors = [](const QImage& image) {
    const int y = image.height() / 2;
    return std::pair(image.pixelColor(image.width() / 3, y), image.pixelColor(2 * image.width() / 3, y));
  };
  const std::pair<QColor, QColor> wanted(Qt::red, Qt::blue);
  EXPECT_EQ(colors(window.findChild<LiveImage*>()->grab().toImage()), wanted);
  auto* list = window.findChild<ProgramList*>();
  const QIcon icon = list->topLevelItem(0)->icon(0);
  ASSERT_FALSE(icon.isNull());
  EXPECT_EQ(colors(icon.pixmap(48, 36).toImage()), wanted);
}

TEST_F(MainWindowTest, ADragIsOneGesture) {
  appear();
  sent.clear();
  auto* slider = setting("ao.samples")->findChild<QSlider*>();
  slider->setSliderDown(true);
  for (int i = 1; i < 50; ++i) slider->setValue(i * 10);
  EXPECT_EQ(sent.size(), 1u) << "the others wait a moment";
  const int last = static_cast<int>(setting("ao.samples")->findChild<QDoubleSpinBox*>()->value());
  ASSERT_TRUE(QTest::qWaitFor([&] { return sent.size() == 2; }));
  EXPECT_EQ(sent[1]["values"]["ao.samples"], last) << "the newest one";
  slider->setSliderDown(false);
  ASSERT_EQ(sent.size(), 3u);
  EXPECT_EQ(sent[2]["values"]["ao.samples"], last);
  for (const json& message : sent) EXPECT_EQ(message["gesture"], sent[0]["gesture"]);
  EXPECT_FALSE(sent[0]["gesture"].get<std::string>().empty());
  const json first = sent[0]["gesture"];
  slider->setSliderDown(true);
  slider->setValue(3);
  EXPECT_NE(sent.back()["gesture"], first);
}

TEST_F(MainWindowTest, ValuesOfTheProgramDoNotMoveASliderThatIsHeld) {
  appear();
  auto* slider = setting("ao.samples")->findChild<QSlider*>();
  slider->setSliderDown(true);
  slider->setValue(900);
  take({{"type", "event"},
        {"what", "settings"},
        {"program", 1},
        {"values", {{"ao.samples", {{"value", 2}, {"layer", "live"}, {"place", ""}}}}}});
  EXPECT_EQ(slider->value(), 900);
}

TEST_F(MainWindowTest, KeysThatFollowEachOtherAreOneGesture) {
  appear();
  sent.clear();
  auto* slider = setting("ao.samples")->findChild<QSlider*>();
  for (int i = 0; i < 5; ++i) QTest::keyClick(slider, Qt::Key_PageUp);
  ASSERT_EQ(sent.size(), 5u);
  for (const json& message : sent) EXPECT_EQ(message["gesture"], sent[0]["gesture"]);
}

TEST_F(MainWindowTest, ANumberThatIsTypedStays) {
  appear();
  window.activateWindow();
  reveal(*setting("ao.samples"));
  auto* box = setting("ao.samples")->findChild<QDoubleSpinBox*>();
  box->setFocus();
  QTest::qWait(1);
  ASSERT_TRUE(box->hasFocus());
  box->selectAll();
  QTest::keyClicks(box, "51");
  take({{"type", "event"}, {"what", "settings"}, {"program", 1}, {"values", json::object()}});
  EXPECT_EQ(box->text(), "51 rays");
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(sent.back()["values"], json({{"ao.samples", 51}}));
}

TEST_F(MainWindowTest, ReturnInABoxThatWasNotTouchedSendsNothing) {
  appear();
  take({{"type", "event"},
        {"what", "settings"},
        {"program", 1},
        {"values", {{"ao.radius", {{"value", 0.123456789}, {"layer", "user"}, {"place", "f:1"}}}}}});
  sent.clear();
  auto* box = setting("ao.radius")->findChild<QDoubleSpinBox*>();
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_TRUE(sent.empty());
  box->selectAll();
  QTest::keyClicks(box, "0,25");  // as some write it
  QTest::keyClick(box, Qt::Key_Return);
  ASSERT_EQ(sent.size(), 1u);
  EXPECT_EQ(sent[0]["values"], json({{"ao.radius", 0.25}}));
}

TEST_F(MainWindowTest, SearchesInAllPages) {
  appear();
  auto* search = window.findChild<QLineEdit*>("search");
  ASSERT_NE(search, nullptr);
  QTest::keyClicks(search, "Aperture radius");
  auto* tabs = window.findChild<QTabWidget*>();
  EXPECT_EQ(tabs->tabText(tabs->currentIndex()).section(' ', 0, 0), "Camera");
  EXPECT_TRUE(setting("camera.aperture")->isVisible());
  EXPECT_FALSE(tabs->isTabVisible(0)) << "a page without matches";
  image("panel-search");
  search->clear();
  EXPECT_EQ(tabs->tabText(0), "Quality");
  for (int i = 0; i < tabs->count(); ++i) EXPECT_TRUE(tabs->isTabVisible(i)) << i;
}

TEST_F(MainWindowTest, HidesWhatIsNotChanged) {
  appear();
  auto* changed = window.findChild<QCheckBox*>("changed");
  ASSERT_NE(changed, nullptr);
  changed->click();
  EXPECT_TRUE(setting("ao")->isVisible());
  EXPECT_FALSE(setting("ao.samples")->isVisible());
  image("panel-changed");
}

TEST_F(MainWindowTest, PresetsAndUndoAreRequests) {
  appear();
  auto* presets = window.findChild<QComboBox*>("presets");
  ASSERT_NE(presets, nullptr);
  presets->setCurrentText("draft");
  emit presets->activated(presets->currentIndex());
  EXPECT_EQ(sent.back()["values"], json({{"preset", "draft"}}));
  for (QAction* action : window.findChildren<QAction*>())
    if (action->text() == "Undo") action->trigger();
  EXPECT_EQ(sent.back()["type"], "undo");
}

}  // namespace
}  // namespace gluray::panel
