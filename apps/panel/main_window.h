// The panel's window: programs on the left, pages of settings on the right. GUI thread.
#pragma once
#include "model/controls.h"

#include <QMainWindow>
#include <vector>

class QAction;
class QCheckBox;
class QComboBox;
class QLineEdit;
class QTabWidget;

namespace gluray::panel {

class SettingsPage;
class WhyPage;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Controls& controls);

 private:
  QWidget* makePrograms();
  QWidget* makePages();
  void makeToolBar();
  void makePresets();
  void showSettings();
  void showState(int program);
  void filter();
  void greet();

  Controls& controls_;
  QTabWidget* tabs_ = nullptr;
  std::vector<SettingsPage*> pages_;
  std::vector<QString> titles_;
  WhyPage* why_ = nullptr;
  QComboBox* presets_ = nullptr;
  QLineEdit* search_ = nullptr;
  QCheckBox* changedOnly_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr;
};

}  // namespace gluray::panel
