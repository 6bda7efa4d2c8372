// A box for a number of a setting's range: as many digits as the number needs, steps that fit its size. GUI
// thread.
#pragma once
#include "settings/rows.h"

#include <QDoubleSpinBox>

namespace gluray::panel {

class NumberBox : public QDoubleSpinBox {
 public:
  NumberBox(const Row& row, QWidget* parent);
  QString textFromValue(double value) const override;
  double valueFromText(const QString& text) const override;
  QValidator::State validate(QString& text, int& at) const override;
  void stepBy(int steps) override;
  /// Whether the user has begun to type and not finished.
  bool typing() const;

 protected:
  void wheelEvent(QWheelEvent* event) override;

 private:
  const bool whole_;
};

}  // namespace gluray::panel
