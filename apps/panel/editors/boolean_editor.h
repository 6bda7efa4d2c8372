// A switch. GUI thread.
#pragma once
#include "editors/editor.h"

class QCheckBox;

namespace gluray::panel {

class BooleanEditor : public Editor {
 public:
  BooleanEditor(const Row& row, QWidget* parent);
  void show(const nlohmann::json& value) override;

 private:
  QCheckBox* box_;
};

}  // namespace gluray::panel
