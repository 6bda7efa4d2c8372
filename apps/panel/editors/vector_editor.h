// Three numbers. GUI thread.
#pragma once
#include "editors/editor.h"

#include <array>

class QDoubleSpinBox;

namespace gluray::panel {

class VectorEditor : public Editor {
 public:
  VectorEditor(const Row& row, QWidget* parent);
  void show(const nlohmann::json& value) override;

 private:
  std::array<QDoubleSpinBox*, 3> boxes_;
};

}  // namespace gluray::panel
