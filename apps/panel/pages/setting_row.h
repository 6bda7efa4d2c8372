// One setting in the panel: its name, an editor, a button that resets it. GUI thread.
#pragma once
#include "model/controls.h"
#include "settings/rows.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <string>

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

 private:
  void send(const nlohmann::json& value, bool more);
  void takeBack();

  const Row& row_;
  Controls& controls_;
  QLabel* label_;
  Editor* editor_;
  QToolButton* reset_;
  bool changed_ = false;
  Value before_;                         // the value when the movement began
  QElapsedTimer last_;                   // since the last change
  bool moving_ = false;                  // further changes of the movement follow
  std::string gesture_;                  // of the movement that goes on; empty: none
  QTimer pause_;                         // runs for a moment after each change of a movement
  std::optional<nlohmann::json> waits_;  // the newest value meanwhile
};

}  // namespace gluray::panel
