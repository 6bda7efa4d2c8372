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

class LightPanel;
class LiveView;
class LiveWindow;
class ObjectsPage;
class SettingsPage;
class WhyPage;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Controls& controls);
  ~MainWindow() override;

 protected:
  /// Ends what changes settings for a while; finishChanges() then waits until they are set back.
  void closeEvent(QCloseEvent* event) override;
  // Files that are dropped anywhere.
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  QWidget* makePrograms();
  QWidget* makePages();
  void makeToolBar();
  void makePresets();
  void showSettings();
  void showState(int program);
  void filter();
  void greet();
  /// One line for the user. Of a tool: it stays when a request has been carried out.
  void say(const QString& line, bool ofTool);
  void listenTo(LiveView& view);
  void showPicked(int program, uint32_t object);
  void enlarge();
  void takeFile(const QString& file);

  Controls& controls_;
  QTabWidget* tabs_ = nullptr;
  std::vector<SettingsPage*> pages_;
  LightPanel* light_ = nullptr;
  ObjectsPage* objects_ = nullptr;
  WhyPage* why_ = nullptr;
  LiveWindow* large_ = nullptr;  // null until it is wanted
  bool toolSpoke_ = false;       // the line in the status bar is a tool's
  QComboBox* presets_ = nullptr;
  QLineEdit* search_ = nullptr;
  QCheckBox* changedOnly_ = nullptr;
  QAction *undo_ = nullptr, *redo_ = nullptr;
};

}  // namespace gluray::panel
