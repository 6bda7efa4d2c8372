// A widget that paints something of the shown program. GUI thread.
#pragma once
#include "model/controls.h"

#include <QWidget>

namespace gluray::panel {

class ShownWidget : public QWidget {
  Q_OBJECT

 public:
  /// `name`: what screen readers call it.
  ShownWidget(Controls& controls, const QString& name, QWidget* parent);

 protected:
  Controls& controls() { return controls_; }
  const Program* program() const { return controls_.shown(); }
  /// Paints the place of what is not there.
  void paintNothing(const QString& text);
  /// Another program is shown, or none; it is painted anyway.
  virtual void programChanged() {}

 private:
  Controls& controls_;
  int shown_ = 0;
};

}  // namespace gluray::panel
