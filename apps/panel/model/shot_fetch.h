// Gets the image of a program's window in its full size: the calls `shot` and `pixels`. Ends by itself.
// GUI thread.
#pragma once
#include "model/calls.h"

#include <QImage>
#include <QObject>
#include <QString>
#include <functional>

namespace gluray::panel {

class Controls;

class ShotFetch : public QObject {
  Q_OBJECT

 public:
  /// What is called once, unless the fetch is deleted before: the image, or why there is none.
  using Taker = std::function<void(const QImage& image, const QString& why)>;

  ShotFetch(Controls& controls, int program, QObject* parent, Taker then);
  /// Asks for a shot and its pixels.
  void shoot();
  /// Asks for the pixels of a shot that is there: the value of a call `shot`.
  void fetch(const nlohmann::json& shot);

 private:
  void askRow();
  /// Empty, or what is wrong with the piece.
  std::string takeRows(const nlohmann::json& piece);
  void finish(const QImage& image, const std::string& why);

  Controls& controls_;
  const int program_;
  Taker then_;
  int shot_ = 0, row_ = 0;  // number of the shot, first row that is missing
  QImage image_;
};

}  // namespace gluray::panel
