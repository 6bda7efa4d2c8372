// For tests: the window, and a program with objects and lights that answers.
#pragma once
#include "main_window.h"
#include "pages/live/live_view.h"
#include "testing/fake_program.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QDropEvent>
#include <QMimeData>
#include <QStatusBar>
#include <QTabWidget>
#include <cstdlib>

namespace gluray::panel {

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
  static void image(QWidget& widget, const char* name) {
    if (const char* folder = std::getenv("GLURAY_PICTURES"))
      widget.grab().save(QString("%1/%2.png").arg(folder, name));
  }

  FakeProgram program;
  MainWindow window{program.controls};
};

}  // namespace gluray::panel
