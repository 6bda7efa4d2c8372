// Values of the shown program's state over the last minutes. GUI thread.
#pragma once
#include "pages/shown_widget.h"

#include <deque>

namespace gluray::panel {

class Plot : public ShownWidget {
  Q_OBJECT

 public:
  Plot(Controls& controls, const QString& name, QWidget* parent);
  QSize sizeHint() const override;

 protected:
  /// Paints a line from 0, below, to `top`; entries that are no numbers are gaps.
  void paintLine(const std::deque<double>& values, double top, QPalette::ColorRole color);
  void paintText(Qt::Alignment where, const QString& text);
  /// The least of 1, 2, 5, 10, 20 ... times a power of ten that is not below any of the values; `least` at
  /// least.
  static double topFor(const std::deque<double>& values, double least);
  virtual void stateCame() { QWidget::update(); }
};

/// Frames a second.
class FpsPlot : public Plot {
  Q_OBJECT

 public:
  FpsPlot(Controls& controls, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

/// Noise and passes of the image that is refined; hidden while there is none.
class NoisePlot : public Plot {
  Q_OBJECT

 public:
  NoisePlot(Controls& controls, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void programChanged() override { stateCame(); }
  void stateCame() override;

 private:
  QString progress() const;
};

}  // namespace gluray::panel
