// The chosen program's frames a second over the last minutes. GUI thread.
#pragma once
#include "model/controls.h"

#include <QWidget>

namespace gluray::panel {

class FpsPlot : public QWidget {
  Q_OBJECT

 public:
  FpsPlot(Controls& controls, QWidget* parent);
  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Controls& controls_;
};

}  // namespace gluray::panel
