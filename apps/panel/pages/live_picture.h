// The picture that a window of the chosen program shows. GUI thread.
#pragma once
#include "model/controls.h"

#include <QWidget>

namespace gluray::panel {

class LivePicture : public QWidget {
  Q_OBJECT

 public:
  LivePicture(Controls& controls, QWidget* parent);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Controls& controls_;
};

}  // namespace gluray::panel
