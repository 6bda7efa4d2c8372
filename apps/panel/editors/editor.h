// Widgets that show and change one setting, made from its row in the table of settings. GUI thread.
#pragma once
#include "settings/rows.h"

#include <nlohmann/json.hpp>

#include <QWidget>

namespace gluray::panel {

class Editor : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;
  /// Shows a value; emits nothing.
  virtual void show(const nlohmann::json& value) = 0;
  /// Whether the user is just changing it: then show() would be in the way.
  virtual bool busy() const { return false; }

 signals:
  /// The user has chosen a value. `more`: further changes of the same movement follow.
  void changed(const nlohmann::json& value, bool more);
  /// The user takes the changes of this movement back.
  void cancelled();
};

/// The editor for the setting's type and range; `name` is what screen readers call it.
Editor* makeEditor(const Row& row, QWidget* parent);

}  // namespace gluray::panel
