// The window of `gluray view`: a saved scene, looks for it, and pictures of it. GUI thread.
#pragma once
#include "view/look.h"
#include "view/saved_picture.h"
#include "view/view_thread.h"

#include <QMainWindow>
#include <memory>
#include <string>

class QComboBox;
class QLabel;
class QListWidget;

namespace gluray::panel {

class LookSettings;
class ViewWidget;

class ViewWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// `scene`: the file, as the user named it; `gluray`: the launcher.
  ViewWindow(std::unique_ptr<EngineView> view, QString scene, QString gluray, LookOptions look);
  ~ViewWindow() override;

  ViewWidget& view() { return *widget_; }
  /// Asks for a name, and saves.
  void askAndSave();
  /// Saves what is shown, in the size that is chosen.
  void save(const QString& file);
  /// To the clipboard.
  void copy();
  /// Takes the settings of a preset or of a quality, beside those that were given; empty: none.
  void setPreset(const QString& preset);
  void setQuality(const QString& quality);

 signals:
  /// A picture was saved, by this command.
  void saved(const QString& command);
  void saveFailed(const QString& why);

 private:
  void makeSide();
  void makeActions();
  void showStep(const ShownView& view);
  void showLine(const QString& line);
  PictureWish wishFor(const QString& file) const;

  QWidget* makeLooks(QWidget* parent);
  QWidget* makeQualities(QWidget* parent);
  QWidget* makeSettings(QWidget* parent);
  void takeLook();

  const QString scene_;
  const std::vector<Preset> presets_;
  LookOptions look_;
  ViewThread thread_;
  ViewWidget* widget_;
  QListWidget* looks_ = nullptr;
  LookSettings* settings_ = nullptr;
  QComboBox *sizes_ = nullptr, *qualities_ = nullptr;
  QLabel* step_;
  PictureProcess picture_;
  QString folder_;  // of the last picture
};

}  // namespace gluray::panel
