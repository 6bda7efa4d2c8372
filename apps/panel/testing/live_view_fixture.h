// For tests: the live view, and a program that answers.
#pragma once
#include "pages/live/live_view.h"
#include "testing/fake_program.h"

#include <gtest/gtest.h>

#include <QTest>
#include <QToolButton>

namespace gluray::panel {

struct LiveViewFixture : testing::Test {
  void SetUp() override {
    QObject::connect(&view, &LiveView::said, &view, [this](const QString& line) { said << line; });
    QObject::connect(&view, &LiveView::picked, &view,
                     [this](int, uint32_t object) { picked.push_back(object); });
    program.appear();
    view.liveImage().setFixedSize(200, 150);
    view.show();
  }
  QToolButton& button(const char* name) { return *view.findChild<QToolButton*>(name); }
  LiveImage& liveImage() { return view.liveImage(); }
  QColor pixel(int x, int y) {
    const QImage image = liveImage().grab().toImage();
    return image.pixelColor((QPointF(x, y) * image.devicePixelRatio()).toPoint());
  }
  void press(int x, int y) { QTest::mousePress(&liveImage(), Qt::LeftButton, {}, {x, y}); }
  void move(int x, int y) { QTest::mouseMove(&liveImage(), {x, y}); }
  void release(int x, int y) { QTest::mouseRelease(&liveImage(), Qt::LeftButton, {}, {x, y}); }
  void click(int x, int y) { press(x, y), release(x, y); }

  FakeProgram program;
  LiveView view{program.controls, nullptr};
  QStringList said;
  std::vector<uint32_t> picked;
};

}  // namespace gluray::panel
