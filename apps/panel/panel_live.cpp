// The panel with a real hub and real programs, on an X server: panel_live GLURAY CLIENT FOLDER; leaves
// images in the folder.
#include "control/runtime_directory.h"
#include "main_window.h"
#include "model/controls.h"
#include "model/film.h"
#include "model/hub_thread.h"
#include "pages/live/live_view.h"
#include "pages/objects/objects_page.h"
#include "testing/reveal.h"
#include "wake/wake.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QProcess>
#include <QSlider>
#include <QStatusBar>
#include <QStyleOptionSlider>
#include <QTabWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <csignal>
#include <functional>
#include <memory>

namespace gluray::panel {
namespace {

QString g_gluray, g_client, g_folder;  // of the command line
constexpr int kPatience = 30000;       // milliseconds

bool until(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatience); }

class PanelLiveTest : public testing::Test {
 protected:
  void SetUp() override {
    qputenv("GLURAY_RUNTIME", (folder_.path() + "/run").toUtf8());
    QObject::connect(&thread_, &HubThread::connected, &controls_, &Controls::connected);
    QObject::connect(&thread_, &HubThread::received, &controls_, &Controls::receiveMessage);
    QObject::connect(&thread_, &HubThread::lost, &controls_, &Controls::disconnected);
  }
  void TearDown() override {
    for (const auto& process : processes_) process->kill(), process->waitForFinished();
  }
  QProcess& start(const QString& program, const QStringList& words) {
    processes_.push_back(std::make_unique<QProcess>());
    processes_.back()->start(program, words);
    EXPECT_TRUE(processes_.back()->waitForStarted(kPatience));
    return *processes_.back();
  }
  /// A program of this name that draws all the time.
  QProcess& program(const QString& name) {
    const QString path = folder_.path() + "/" + name;
    QFile::link(g_client, path);
    return start(g_gluray, {"--", path, "always", "20"});
  }
  void show(size_t programs) {
    window_.show();
    thread_.start();
    ASSERT_TRUE(until([&] { return controls_.programs().size() == programs; }));
    if (programs > 1) controls_.chooseAll();
    ASSERT_TRUE(until([&] { return controls_.shown() && controls_.shown()->fps.size() > 4; }));
  }
  /// What `gluray get --live` prints of the setting, a line for each program.
  QString live(const QString& name) {
    QProcess get;
    get.start(g_gluray, {"get", "--live", name});
    EXPECT_TRUE(until([&] { return get.state() == QProcess::NotRunning; }));
    return QString::fromUtf8(get.readAllStandardOutput());
  }
  bool becomes(const QString& name, const QString& value) {
    return until([&] {
      const QStringList lines = live(name).split('\n', Qt::SkipEmptyParts);
      return !lines.empty() && std::all_of(lines.begin(), lines.end(),
                                           [&](auto& line) { return line.section(" = ", -1) == value; });
    });
  }
  void image(const char* name) { window_.grab().save(QString("%1/panel-%2.png").arg(g_folder, name)); }
  /// A widget of a setting's editor, which is brought into view.
  template <class Widget>
  Widget& part(const char* setting) {
    auto* editor = window_.findChild<QWidget*>(setting);
    if (!QString(setting).startsWith("object.")) reveal(*editor);
    return *editor->findChild<Widget*>();
  }
  LiveView& view() { return *window_.findChild<LiveView*>(); }
  /// Shows the only program. Returns where its image has a surface.
  QPoint showAndPoint() {
    show(1);
    LiveImage& live_ = view().liveImage();
    EXPECT_TRUE(until([&] { return !live_.imageRect().isEmpty(); }));
    const QRectF room = live_.imageRect();
    return (room.topLeft() + QPointF(room.width() * 0.5, room.height() * 0.8)).toPoint();
  }
  void drag(QSlider& slider, double from, double to) {
    QStyleOptionSlider option;
    option.initFrom(&slider);
    option.minimum = slider.minimum(), option.maximum = slider.maximum();
    option.sliderPosition = option.sliderValue = slider.value(), option.subControls = QStyle::SC_All;
    const QRect handle =
        slider.style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, &slider);
    QTest::mousePress(&slider, Qt::LeftButton, {}, handle.center());
    for (int i = 0; i <= 40; ++i) {
      const double share = from + (to - from) * i / 40;
      QTest::mouseMove(&slider, {static_cast<int>(share * slider.width()), handle.center().y()});
      QTest::qWait(1);
    }
    QTest::mouseRelease(&slider, Qt::LeftButton, {},
                        {static_cast<int>(to * slider.width()), handle.center().y()});
  }

  QTemporaryDir folder_;
  Controls controls_{[this](nlohmann::json message) { thread_.send(std::move(message)); }};
  HubThread thread_{{(folder_.path() + "/run").toStdString(), "", ""}, wakeWindow};
  MainWindow window_{controls_};
  std::vector<std::unique_ptr<QProcess>> processes_;
};

TEST_F(PanelLiveTest, WhatIsMovedReachesTheProgram) {
  program("painter");
  show(1);
  image("program");
  drag(part<QSlider>("ao.samples"), 0.3, 0.8);
  const int samples = static_cast<int>(part<QDoubleSpinBox>("ao.samples").value());
  EXPECT_GT(samples, 16);
  EXPECT_TRUE(becomes("ao.samples", QString::number(samples))) << qPrintable(live("ao.samples"));
  QTest::mouseClick(&part<QCheckBox>("shadows"), Qt::LeftButton, {},
                    {8, part<QCheckBox>("shadows").height() / 2});
  EXPECT_TRUE(becomes("shadows", "true"));
  auto* presets = window_.findChild<QComboBox*>("presets");
  presets->setFocus();
  QTest::keyClick(presets, Qt::Key_Down);
  EXPECT_TRUE(becomes("preset", presets->itemText(1)));
  ASSERT_TRUE(until([&] { return presets->currentIndex() == 1; }));
  image("changed");
  window_.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&window_, kPatience));
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(until([&] { return presets->currentIndex() == 0; }));
  EXPECT_FALSE(live("preset").contains(presets->itemText(1))) << qPrintable(live("preset"));
  EXPECT_TRUE(becomes("shadows", "true"));
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(becomes("shadows", "false"));
  QTest::keyClick(&window_, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(becomes("ao.samples", "16")) << "the drag is one step: " << qPrintable(live("ao.samples"));
  EXPECT_TRUE(until([&] { return part<QDoubleSpinBox>("ao.samples").value() == 16; }));
  image("undone");
}

TEST_F(PanelLiveTest, TakesTheHubsPlaceAndForgetsProgramsThatEnd) {
  QProcess& hub = start(g_gluray, {"hub"});
  ASSERT_TRUE(until([&] { return hub.readAllStandardError().contains("the hub listens"); }));
  QProcess& painter = program("painter");
  program("other");
  show(2);
  image("two-programs");
  hub.kill();
  ASSERT_TRUE(until([&] { return controls_.programs().empty(); }));
  image("hub-lost");
  ASSERT_TRUE(until([&] { return controls_.programs().size() == 2; }));
  QTest::mouseClick(&part<QCheckBox>("ao"), Qt::LeftButton, {}, {8, part<QCheckBox>("ao").height() / 2});
  EXPECT_TRUE(becomes("ao", "true"));
  EXPECT_EQ(live("ao").count('\n'), 2);
  painter.kill();
  ASSERT_TRUE(until([&] { return controls_.programs().size() == 1; }));
  processes_.back()->kill();
  ASSERT_TRUE(until([&] { return controls_.programs().empty(); }));
  EXPECT_FALSE(part<QCheckBox>("ao").isEnabled());
  EXPECT_TRUE(window_.statusBar()->currentMessage().startsWith("No program runs"));
  image("ended");
}

TEST_F(PanelLiveTest, PickedObjectsGetMaterials) {
  program("painter");
  const QPoint surface = showAndPoint();
  QTest::mouseClick(&view().liveImage(), Qt::LeftButton, {}, surface);
  auto& objects = *window_.findChild<ObjectsPage*>();
  ASSERT_TRUE(until([&] { return objects.isVisible(); }))
      << qPrintable(window_.statusBar()->currentMessage());
  auto& rows = *objects.findChild<QTableView*>()->selectionModel();
  ASSERT_TRUE(until([&] { return rows.selectedRows().size() == 1; }));
  const QString object = rows.selectedRows()[0].data().toString();
  auto& material = part<QComboBox>("object.material");
  material.setFocus();
  while (material.currentText() != "plastic") QTest::keyClick(&material, Qt::Key_Down);
  EXPECT_TRUE(becomes("material.objects", object + " plastic")) << qPrintable(live("material.objects"));
  EXPECT_TRUE(until([&] { return controls_.undoSteps() > 0; }));
  const QModelIndex index = rows.selectedRows()[0];
  EXPECT_TRUE(until([&] { return index.siblingAtColumn(int(ObjectColumn::material)).data() == "plastic"; }))
      << "the program says so, too";
  image("picked");
}

TEST_F(PanelLiveTest, LightFollowsTheMouse) {
  program("painter");
  const QPoint surface = showAndPoint();
  openPage(*window_.findChild<QWidget*>("lights"));
  LiveImage& live_ = view().liveImage();
  window_.findChild<QAbstractButton*>("tool-light")->click();
  QTest::mousePress(&live_, Qt::LeftButton, {}, surface);
  for (int i = 0; i < 20; ++i) QTest::mouseMove(&live_, surface + QPoint(i, 0)), QTest::qWait(5);
  QTest::mouseRelease(&live_, Qt::LeftButton, {}, surface + QPoint(20, 0));
  EXPECT_TRUE(becomes("lights", "headlight+key"));
  EXPECT_TRUE(until([&] { return controls_.isLive("lights.azimuth"); }));
  EXPECT_TRUE(until([&] { return controls_.undoSteps() == 1; })) << controls_.undoSteps();
  image("light");
}

TEST_F(PanelLiveTest, ComparesAndFilms) {
  program("painter");
  showAndPoint();
  window_.findChild<QAbstractButton*>("tool-compare")->click();
  ASSERT_TRUE(until([&] { return !view().openGlImage().isNull(); }))
      << qPrintable(window_.statusBar()->currentMessage());
  EXPECT_TRUE(until([&] { return !controls_.isLive("engine"); })) << "it traces again";
  image("compare");

  Film film(controls_, {folder_.path(), "film", 4, "lights.azimuth", 0, 90, false}, nullptr);
  bool ended = false;
  QObject::connect(&film, &Film::finished, &film, [&](const QString& why) {
    EXPECT_EQ(why.toStdString(), "");
    ended = true;
  });
  film.start();
  ASSERT_TRUE(until([&] { return ended; }));
  const QImage first(film.fileOf(0)), last(film.fileOf(3));
  EXPECT_EQ(first.size(), view().openGlImage().size());
  EXPECT_NE(first, last);
}

TEST_F(PanelLiveTest, Pages) {
  program("painter");
  show(1);
  auto* tabs = window_.findChild<QTabWidget*>();
  for (int i = 0; i < tabs->count(); ++i) {
    tabs->setCurrentIndex(i);
    QTest::qWait(300);
    image(qPrintable("page-" + tabs->tabText(i).toLower()));
  }
}

}  // namespace
}  // namespace gluray::panel

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  QApplication application(argc, argv);
  const gluray::panel::OwnMemory memory;
  using namespace gluray::panel;
  if (argc < 4) return 2;
  g_gluray = argv[1], g_client = argv[2], g_folder = argv[3];
  return RUN_ALL_TESTS();
}
