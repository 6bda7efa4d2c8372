// A page of settings, with a box for each heading. GUI thread.
#pragma once
#include "pages/layout.h"
#include "pages/setting_row.h"

#include <QGroupBox>
#include <QScrollArea>
#include <utility>
#include <vector>

class QVBoxLayout;

namespace gluray::panel {

class SettingsPage : public QScrollArea {
  Q_OBJECT

 public:
  SettingsPage(const Page& page, Controls& controls, QWidget* parent);
  /// Shows what the chosen program has.
  void update();
  /// Hides settings that do not match, and with `changedOnly` those that have their built-in values. Returns
  /// how many are left.
  int filter(const QString& search, bool changedOnly);
  /// Puts a widget above the settings; it is hidden while settings are searched.
  void setTop(QWidget* top);
  /// Whether the settings can be changed.
  void setUsable(bool usable);

 private:
  void addSection(const Section& section);

  Controls& controls_;
  QVBoxLayout* layout_;
  QWidget* top_ = nullptr;
  std::vector<std::pair<QGroupBox*, std::vector<SettingRow*>>> boxes_;
};

}  // namespace gluray::panel
