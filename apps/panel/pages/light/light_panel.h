// The top of the page Light: the ball for the key light's direction, and the lights that shine. GUI thread.
#pragma once
#include <QGroupBox>

namespace gluray::panel {

class Controls;
class LightSphere;

class LightPanel : public QGroupBox {
  Q_OBJECT

 public:
  LightPanel(Controls& controls, QWidget* parent);
  /// Shows what the chosen program has.
  void update();

 signals:
  void said(const QString& line);

 private:
  LightSphere* sphere_;
};

}  // namespace gluray::panel
