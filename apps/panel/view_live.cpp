// The window of `gluray view` with the engine's library, on an X server: view_live ENGINE GLURAY SCENE
// FOLDER; works in the folder, and leaves images of the window there.
// view_live ENGINE GLURAY SCENE FILE --picture LOOK RIGHT,UP: makes an image of the window.
#include "view/look_settings.h"
#include "view/view_widget.h"
#include "view/view_window.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QColorSpace>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>
#include <QWheelEvent>
#include <cstring>
#include <ctime>
#include <functional>
#include <memory>

namespace gluray::panel {
namespace {

QString g_engine, g_gluray, g_scene, g_folder;  // of the command line
constexpr int kPatience = 60000;                // milliseconds

bool until(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatience); }

/// Of all threads of this process.
double processorSeconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The pixels alone, whatever the files say of their colours.
QImage pixelsOf(const QImage& image) {
  QImage pixels = image.convertToFormat(QImage::Format_RGBA8888_Premultiplied);
  pixels.setColorSpace({});
  return pixels;
}

class ViewLiveTest : public testing::Test {
 protected:
  void SetUp() override { open({}); }
  void open(LookOptions look) {
    window_ = std::make_unique<ViewWindow>(
        std::make_unique<EngineView>(g_engine.toStdString(), g_scene.toStdString()), g_scene, g_gluray,
        std::move(look));
    QObject::connect(&view(), &ViewWidget::progressed, window_.get(), [this](const ShownView& shown) {
      finished_ = shown.finished;
      moving_ += shown.moving;
    });
    QObject::connect(window_.get(), &ViewWindow::saved, window_.get(),
                     [this](const QString& line) { command_ = line; });
    QObject::connect(window_.get(), &ViewWindow::saveFailed, window_.get(),
                     [this](const QString& line) { why_ = line; });
    finished_ = false;
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  }
  ViewWidget& view() { return window_->view(); }
  QString line() { return window_->statusBar()->findChild<QLabel*>()->text(); }
  bool finish() {
    return until([&] { return finished_; });
  }
  /// A change that `work` makes, and the finished picture after it.
  bool after(const std::function<void()>& work) {
    finished_ = false;
    work();
    return finish();
  }
  void drag(Qt::MouseButton button, QPoint from, QPoint to) {
    QTest::mousePress(&view(), button, {}, from);
    for (int i = 1; i <= 10; ++i) {
      QMouseEvent move(QEvent::MouseMove, QPointF(from + (to - from) * i / 10), view().mapToGlobal(from),
                       Qt::NoButton, button, {});
      QApplication::sendEvent(&view(), &move);
      QTest::qWait(10);
    }
    QTest::mouseRelease(&view(), button, {}, to);
  }
  /// What a saved picture of the view has.
  QImage saved(const QString& name) {
    command_.clear(), why_.clear();
    window_->save(name);
    EXPECT_TRUE(until([&] { return !command_.isEmpty() || !why_.isEmpty(); }));
    EXPECT_TRUE(why_.isEmpty()) << why_.toStdString();
    return pixelsOf(QImage(name));
  }
  /// Whether the finished picture has the pixels of the saved one, and its command makes it again.
  void expectAsSaved(const QString& name) {
    const QImage picture = saved(name);
    EXPECT_EQ(picture.size(), view().pixels());
    EXPECT_TRUE(picture == pixelsOf(view().image())) << command_.toStdString();
    QFile::rename(name, "first-" + name);
    EXPECT_EQ(QProcess::execute("/bin/sh", {"-c", "PATH=" + QFileInfo(g_gluray).path() + ":$PATH; " +
                                                      command_ + " >/dev/null"}),
              0);
    EXPECT_TRUE(QImage(name) == QImage("first-" + name)) << command_.toStdString();
    EXPECT_EQ(QProcess::execute(g_gluray, {"render", "--again", name, "--json"}), 0);
    EXPECT_TRUE(QImage(name) == QImage("first-" + name)) << "again";
  }
  void image(const char* name) { window_->grab().save(QString("%1/view-%2.png").arg(g_folder, name)); }
  static QPoint middleOf(const QWidget& widget) { return widget.rect().center(); }

  std::unique_ptr<ViewWindow> window_;
  bool finished_ = false;
  int moving_ = 0;
  QString command_, why_;
};

TEST_F(ViewLiveTest, ShowsTheSceneAndIsThenAtRest) {
  ASSERT_FALSE(view().image().isNull()) << "the window's pixels, at once";
  ASSERT_TRUE(finish());
  EXPECT_TRUE(line().endsWith("finished")) << line().toStdString();
  image("opened");
  QTest::qWait(500);
  const double before = processorSeconds();
  QTest::qWait(2000);
  EXPECT_LT(processorSeconds() - before, 0.05);
}

TEST_F(ViewLiveTest, PicturesAreThoseOfItsCommands) {
  ASSERT_TRUE(finish());
  expectAsSaved("opened.png");
  EXPECT_FALSE(QFile::exists("opened.png.camera.json")) << "the saved view needs none";
  ASSERT_TRUE(after([&] { drag(Qt::LeftButton, middleOf(view()), middleOf(view()) + QPoint(40, 15)); }));
  ASSERT_TRUE(view().camera());
  EXPECT_GT(moving_, 0);
  image("turned");
  expectAsSaved("it's turned.png");
  EXPECT_TRUE(QFile::exists("it's turned.png.camera.json"));
  ASSERT_TRUE(after([&] { window_->setPreset("draft"); }));
  expectAsSaved("draft.png");
  EXPECT_TRUE(command_.contains("--preset draft"));
  ASSERT_TRUE(after([&] { window_->setPreset({}); }));
  ASSERT_TRUE(after([&] { window_->resize(window_->size() + QSize(60, 20)); }));
  expectAsSaved("larger.png");
}

TEST_F(ViewLiveTest, SettingsOfTheCommandLineCount) {
  window_.reset();
  open({"draft", "", {{"ao", "true"}, {"ao.samples", "2"}, {"noise", "0.05"}, {"exposure", "-1"}}});
  ASSERT_TRUE(finish());
  ASSERT_TRUE(after([&] { view().turn(30, 10); }));
  expectAsSaved("darker.png");
  EXPECT_TRUE(command_.contains("--preset draft --set ao=true --set ao.samples=2")) << command_.toStdString();
}

TEST_F(ViewLiveTest, SettingsBesideTheLookCount) {
  ASSERT_TRUE(finish());
  auto* exposure = window_->findChild<QWidget*>("exposure")->findChild<QDoubleSpinBox*>();
  ASSERT_TRUE(after([&] { exposure->setValue(-1); }));
  expectAsSaved("exposed.png");
  EXPECT_TRUE(command_.contains("--set exposure=-1")) << command_.toStdString();
  image("settings");
  auto* settings = window_->findChild<LookSettings*>();
  ASSERT_TRUE(after([&] { emit settings->chosen("exposure", ""); }));
  EXPECT_EQ(exposure->value(), 0);
}

TEST_F(ViewLiveTest, MouseAndKeysMoveTheView) {
  ASSERT_TRUE(finish());
  const QImage opened = view().image();
  const auto differs = [&](const char* what, const std::function<void()>& work) {
    const auto before = view().camera();
    ASSERT_TRUE(after(work)) << what;
    ASSERT_TRUE(view().camera()) << what;
    EXPECT_FALSE(before && areEqual(*before, *view().camera())) << what;
    EXPECT_FALSE(view().image() == opened) << what;
  };
  const auto key = [&](Qt::Key which, Qt::KeyboardModifiers with = {}) {
    return [this, which, with] { QTest::keyClick(&view(), which, with); };
  };
  differs("right button",
          [&] { drag(Qt::RightButton, middleOf(view()), middleOf(view()) + QPoint(0, -20)); });
  differs("middle button",
          [&] { drag(Qt::MiddleButton, middleOf(view()), middleOf(view()) + QPoint(9, 9)); });
  differs("wheel", [&] {
    QWheelEvent wheel(middleOf(view()), view().mapToGlobal(middleOf(view())), {}, {0, 120}, {}, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view(), &wheel);
  });
  differs("arrow", key(Qt::Key_Left));
  differs("arrow with Shift", key(Qt::Key_Up, Qt::ShiftModifier));
  differs("plus", key(Qt::Key_Plus));
  differs("fit", key(Qt::Key_F));
  const GlurayCamera before = *view().camera();
  for (int i = 0; i < 25 && areEqual(before, *view().camera()); ++i) {  // until one shows a surface
    const QPoint at(view().width() * (1 + i % 5) / 6, view().height() * (1 + i / 5) / 6);
    ASSERT_TRUE(after([&] { QTest::mouseDClick(&view(), Qt::LeftButton, {}, at); }));
  }
  EXPECT_FALSE(areEqual(before, *view().camera())) << "double click";
  ASSERT_TRUE(after(key(Qt::Key_R)));
  EXPECT_FALSE(view().camera());
  EXPECT_TRUE(view().image() == opened);
}

TEST_F(ViewLiveTest, CopiesWhatItShows) {
  ASSERT_TRUE(finish());
  QTest::keyClick(&view(), Qt::Key_C);
  EXPECT_TRUE(pixelsOf(QGuiApplication::clipboard()->image()) == pixelsOf(view().image()));
}

TEST_F(ViewLiveTest, SavesOtherSizesAndForms) {
  ASSERT_TRUE(finish());
  auto* sizes = window_->findChild<QComboBox*>("sizes");
  sizes->setEditText("320x200");
  EXPECT_EQ(saved("small.png").size(), QSize(320, 200));
  sizes->setEditText("large");
  window_->save("never.png");
  EXPECT_TRUE(why_.contains("3840x2160")) << why_.toStdString();
  sizes->setCurrentIndex(0);
  why_.clear();
  window_->save("missing/folder.png");
  ASSERT_TRUE(until([&] { return !why_.isEmpty(); }));
  EXPECT_FALSE(QFile::exists("never.png"));
}

TEST_F(ViewLiveTest, LeavesOtherFilesAlone) {
  ASSERT_TRUE(finish());
  QFile other("mine.png.camera.json");
  ASSERT_TRUE(other.open(QIODevice::WriteOnly));
  other.write("mine"), other.close();
  ASSERT_TRUE(after([&] { view().turn(20, 0); }));
  window_->save("mine.png");
  EXPECT_TRUE(why_.contains("stays as it is")) << why_.toStdString();
  ASSERT_TRUE(other.open(QIODevice::ReadOnly));
  EXPECT_EQ(other.readAll(), "mine");
}

/// An image of the window for documents: a look, and degrees "RIGHT,UP". Returns the exit code.
int picture(const QString& look, const QString& turn) {
  ViewWindow window(std::make_unique<EngineView>(g_engine.toStdString(), g_scene.toStdString()), g_scene,
                    g_gluray, {});
  bool finished = false;
  QObject::connect(&window.view(), &ViewWidget::progressed, &window,
                   [&](const ShownView& shown) { finished = shown.finished; });
  window.show();
  window.setPreset(look);
  window.view().turn(turn.section(',', 0, 0).toDouble(), turn.section(',', 1).toDouble());
  constexpr int kLong = 1500000;  // milliseconds
  if (!QTest::qWaitFor([&] { return finished; }, kLong)) return 1;
  QTest::qWait(100);
  return window.grab().save(g_folder) ? 0 : 1;
}

}  // namespace
}  // namespace gluray::panel

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (argc < 5) return 2;
  using namespace gluray::panel;
  g_engine = argv[1], g_gluray = argv[2], g_scene = argv[3], g_folder = argv[4];
  QApplication application(argc, argv);
  if (argc == 8 && !std::strcmp(argv[5], "--picture")) return picture(argv[6], argv[7]);
  return RUN_ALL_TESTS();
}
