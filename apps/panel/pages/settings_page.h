// A page of settings: the basic ones, a button "More", and below it a box for each other level. GUI thread.
#pragma once
#include "pages/layout.h"
#include "pages/setting_row.h"

#include <QGroupBox>
#include <QScrollArea>
#include <vector>

class QToolButton;
class QVBoxLayout;

namespace gluray::panel {

class SettingsPage : public QScrollArea {
  Q_OBJECT

 public:
  SettingsPage(const Page& page, Controls& controls, QWidget* parent);
  /// Shows what the chosen program has.
  void update();
  /// Hides settings that do not match, and with `changedOnly` those that have their built-in values. Looks at
  /// settings of all levels. Returns how many match.
  int filter(const QString& search, bool changedOnly);
  /// Puts a widget above the settings; it is hidden while settings are searched.
  void setTop(QWidget* top);
  /// Whether the settings can be changed.
  void setUsable(bool usable);

 private:
  struct Box {
    Level level;
    QGroupBox* widget;
    std::vector<SettingRow*> rows;
  };
  void addSection(const Section& section);
  void addMore(size_t settings);
  void alignLabels();
  void showMore(bool shown);
  /// Whether a box shows settings without a filter.
  bool isOpen(const Box& box) const;

  Controls& controls_;
  const QString title_;
  QVBoxLayout* layout_;
  QWidget* top_ = nullptr;
  QToolButton* more_ = nullptr;  // null: the page has settings of one kind only, basic ones or others
  bool filters_ = false;
  std::vector<Box> boxes_;
};

}  // namespace gluray::panel
