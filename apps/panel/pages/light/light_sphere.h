// A ball that shows where the key light comes from, and changes it: its highlight can be dragged. GUI thread.
#pragma once
#include "model/movement.h"
#include "pages/light/light_direction.h"

#include <QImage>
#include <QWidget>

namespace gluray::panel {

class Controls;

class LightSphere : public QWidget {
  Q_OBJECT

 public:
  LightSphere(Controls& controls, QWidget* parent);
  QSize sizeHint() const override;
  /// Shows what the chosen program has.
  void update();
  /// "azimuth 45 degrees, elevation 35 degrees".
  QString valueText() const;

 signals:
  void said(const QString& line);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QRectF ball() const;
  void drag(const QPointF& at, bool more);
  void turnTo(LightDirection direction, bool more);

  Controls& controls_;
  Movement movement_;
  LightDirection direction_;
  bool dragged_ = false;
};

}  // namespace gluray::panel
