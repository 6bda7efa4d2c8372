// A film: images of a program's window, one after the other, each saved as a file. GUI thread; never waits.
#pragma once
#include "model/controls.h"

#include <QObject>
#include <QString>

namespace gluray::panel {

struct FilmPlan {
  QString folder, name;     // images are FOLDER/NAME-0001.png and so on
  int frames = 0;           // 0: until it is stopped
  std::string setting;      // that changes over the film; empty: none. Needs frames above 0
  double from = 0, to = 0;  // its values in the first and the last frame
  bool whole = false;       // the setting is a whole number
};

class Film : public QObject {
  Q_OBJECT

 public:
  /// Of the program that controls.shown() is now, which must be there.
  Film(Controls& controls, FilmPlan plan, QObject* parent);
  void start();
  /// No further image is taken; those that are saved stay. finished() follows.
  void stop();
  int saved() const { return saved_; }
  QString fileOf(int frame) const;  // from 0

 signals:
  void progressed(int saved);
  /// Once. `why`: empty if all frames are there, or stop() was called.
  void finished(const QString& why);

 private:
  void askNextImage();
  void shoot();
  void receiveImage(const QImage& image, const QString& why);
  void finish(const QString& why);
  nlohmann::json valueOf(int frame) const;

  Controls& controls_;
  const FilmPlan plan_;
  const int program_;
  const std::string gesture_;  // all changes of the setting: one step of undo
  nlohmann::json before_;      // its live value before the film; null: none
  int saved_ = 0;
  bool varied_ = false, stopped_ = false, finished_ = false;
};

}  // namespace gluray::panel
