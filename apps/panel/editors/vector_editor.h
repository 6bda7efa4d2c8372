// Three numbers. GUI thread.
#pragma once
#include "editors/editor.h"

#include <array>

namespace gluray::panel {

class NumberBox;

class VectorEditor : public Editor {
 public:
  VectorEditor(const Row& row, QWidget* parent);
  void show(const nlohmann::json& value) override;
  bool busy() const override;

 private:
  std::array<NumberBox*, 3> boxes_;
};

}  // namespace gluray::panel
