// Basic settings of a picture beside the view: over those of the look. GUI thread.
#pragma once
#include "settings/rows.h"
#include "view/look.h"

#include <QScrollArea>
#include <map>
#include <string>
#include <vector>

class QLabel;
class QToolButton;

namespace gluray::panel {

class Editor;

class LookSettings : public QScrollArea {
  Q_OBJECT

 public:
  /// `saved`: values that the scene has, by the names of settings.
  LookSettings(std::map<std::string, std::string> saved, QWidget* parent);
  /// Shows what pictures of this look have.
  void show(const LookOptions& look, const std::vector<Preset>& presets);

 signals:
  /// The user has chosen a value; empty: that of the look.
  void chosen(const std::string& name, const std::string& value);
  /// One line: why a value cannot be.
  void refused(const QString& why);

 private:
  struct Line {
    const Row* row;
    QLabel* label;
    Editor* editor;
    QToolButton* reset;
  };
  void add(const Row& row, QWidget* inside);

  const std::map<std::string, std::string> saved_;
  std::vector<Line> lines_;
};

}  // namespace gluray::panel
