// The window's image in full size while the shown program stands still. GUI thread; never waits.
#pragma once
#include "model/controls.h"

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QTimer>

namespace gluray::panel {

class StillImage : public QObject {
  Q_OBJECT

 public:
  StillImage(Controls& controls, QObject* parent);
  void watch(bool on);

 signals:
  /// Null: the thumbnail is newer.
  void changed(const QImage& image);

 private:
  void forget();
  void thumbnailCame(int program);
  void shoot();

  Controls& controls_;
  QTimer quiet_;        // since the last thumbnail that differs from the one before
  QElapsedTimer last_;  // since the last shot
  QImage thumbnail_;
  uint64_t round_ = 0;
  bool on_ = false, underWay_ = false;
};

}  // namespace gluray::panel
