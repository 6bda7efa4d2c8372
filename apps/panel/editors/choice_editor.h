// A list of words, with their help as tool tips. GUI thread.
#pragma once
#include "editors/editor.h"

class QComboBox;

namespace gluray::panel {

class ChoiceEditor : public Editor {
 public:
  ChoiceEditor(const Row& row, QWidget* parent);
  void show(const nlohmann::json& value) override;

 private:
  QComboBox* box_;
};

}  // namespace gluray::panel
