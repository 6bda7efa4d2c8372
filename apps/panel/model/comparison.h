// The real OpenGL's image of the shown program, to compare GLuRay's with: the setting engine is `never` for
// one frame. GUI thread; never waits.
#pragma once
#include "model/controls.h"

#include <QImage>
#include <QObject>
#include <QTimer>

namespace gluray::panel {

class Comparison : public QObject {
  Q_OBJECT

 public:
  Comparison(Controls& controls, QObject* parent);
  /// While it is on, the image is got anew when the program's windows change their sizes.
  void watch(bool on);
  bool isOn() const { return on_; }
  void renew();
  /// Null: there is none yet, or none can be had.
  const QImage& image() const { return image_; }

 signals:
  void changed();
  void said(const QString& line);

 private:
  void programShown();
  void stateCame(int program);
  void receiveAnswers(const std::vector<CallAnswer>& answers, uint64_t round);

  Controls& controls_;
  QTimer settled_;  // runs while a window may still change its size
  QImage image_;
  nlohmann::json windows_;  // as they were when the image was asked for
  int program_ = 0;
  uint64_t round_ = 0;
  bool on_ = false, underWay_ = false;
};

}  // namespace gluray::panel
