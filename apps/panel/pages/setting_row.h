// One setting in the panel: its title, an editor, a button that resets it. GUI thread.
#pragma once
#include "model/controls.h"
#include "model/movement.h"
#include "settings/rows.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace gluray::panel {

class Editor;

class SettingRow : public QWidget {
  Q_OBJECT

 public:
  SettingRow(const Row& row, Controls& controls, QWidget* parent);
  const Row& row() const { return row_; }
  /// Whether the value differs from the built-in one.
  bool isChanged() const { return changed_; }
  /// Shows what the chosen program has.
  void update();
  QLabel* label() const { return label_; }
  /// Width in pixels that the label needs for its title in bold with the sign of different values.
  int widestLabel() const;
  void setLabelWidth(int width);

 private:
  void send(const nlohmann::json& value, bool more);
  void takeBack();

  const Row& row_;
  Controls& controls_;
  QLabel* label_;
  Editor* editor_;
  QToolButton* reset_;
  bool changed_ = false;
  Value before_;  // the value when the movement began
  Movement movement_;
};

}  // namespace gluray::panel
