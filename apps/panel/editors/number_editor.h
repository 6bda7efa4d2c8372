// A number: a box to type in, and a slider where the setting has a range that one can slide through. GUI
// thread.
#pragma once
#include "editors/editor.h"

class QSlider;

namespace gluray::panel {

class NumberBox;

/// Positions of a slider over a range; logarithmic if the range covers more than three powers of ten.
class Scale {
 public:
  static constexpr int kSteps = 1000;
  /// `usual`: a value of the order that is wanted most often; a range that begins at 0 is fine-grained around
  /// it.
  Scale(double least, double most, double usual);
  /// 0 to kSteps; values outside the range are at its ends.
  int positionOf(double value) const;
  double valueAt(int position) const;

 private:
  double first_, least_, most_;  // first_: of the logarithmic part; 0: linear
};

class NumberEditor : public Editor {
 public:
  NumberEditor(const Row& row, QWidget* parent);
  void show(const nlohmann::json& value) override;
  bool busy() const override;

 private:
  void typed(double value);
  void slid(int position);
  void send(double value, bool more);

  const bool whole_;
  const Scale scale_;
  NumberBox* box_;
  QSlider* slider_ = nullptr;
};

}  // namespace gluray::panel
