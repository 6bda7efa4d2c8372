// Why the real OpenGL draws some things, and what the program warned about. GUI thread.
#pragma once
#include "model/controls.h"

#include <QWidget>

class QLabel;
class QTreeWidget;
class QPlainTextEdit;

namespace gluray::panel {

class WhyPage : public QWidget {
  Q_OBJECT

 public:
  explicit WhyPage(QWidget* parent);
  /// Shows a program's state; null: none.
  void show(const Program* program);

 private:
  QLabel* share_;
  QTreeWidget* reasons_;
  QPlainTextEdit* warnings_;
};

}  // namespace gluray::panel
