// Pictures of what the window shows, made by `gluray render`. GUI thread.
#pragma once
#include "saved/program/view.h"

#include <QProcess>
#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

namespace gluray::panel {

struct PictureWish {
  QString scene, file;
  QSize size;                          // pixels
  std::optional<GlurayCamera> camera;  // none: the saved view
  GlurayCamera saved{};                // that of the saved view, if `camera` is one
  QStringList look;                    // words of options
};

/// The file beside the picture that has the camera of the command.
QString cameraFileOf(const QString& picture);
/// Writes it. Empty, or one line that says why not. A file of that name that is no such file is left alone.
QString writeCameraFile(const PictureWish& wish);
/// The words after `gluray`.
QStringList renderWords(const PictureWish& wish);
/// As a user would type it.
QString commandLine(const QStringList& words);

/// `gluray render` in a process of its own, one at a time. It ends with this object.
class PictureProcess : public QObject {
  Q_OBJECT

 public:
  PictureProcess(QString gluray, QObject* parent);
  ~PictureProcess() override;
  bool isBusy() const { return process_.state() != QProcess::NotRunning; }
  void start(const PictureWish& wish);

 signals:
  /// `command` is empty if the picture could not be made; `line` says why.
  void done(const QString& line, const QString& command);

 private:
  void finish();

  const QString gluray_;
  QProcess process_;
  QString command_;
};

}  // namespace gluray::panel
