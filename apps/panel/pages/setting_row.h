// One setting in the panel: its name, an editor, a button that resets it. GUI thread.
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
  /// The setting heads the group under whose name it stands, such as `ao`: its label does not repeat that.
  void headsGroup();

 private:
  void send(const nlohmann::json& value, bool more);
  void takeBack();

  const Row& row_;
  Controls& controls_;
  QString text_;  // of the label
  QLabel* label_;
  Editor* editor_;
  QToolButton* reset_;
  bool changed_ = false;
  Value before_;  // the value when the movement began
  Movement movement_;
};

}  // namespace gluray::panel
