// A colour: a button that shows it and opens a dialogue. GUI thread.
#pragma once
#include "editors/editor.h"

#include <QColor>

class QPushButton;

namespace gluray::panel {

class ColorEditor : public Editor {
 public:
  ColorEditor(const Row& row, QWidget* parent);
  void show(const nlohmann::json& value) override;

 private:
  void ask();
  QPushButton* button_;
  QColor color_;
};

}  // namespace gluray::panel
