// Changes of settings that belong to one movement of the user, such as a drag: they are one gesture, and one
// step of undo. GUI thread.
#pragma once
#include <nlohmann/json.hpp>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <optional>
#include <string>

namespace gluray::panel {

class Controls;

/// A name that no other gesture has.
std::string newGesture();

class Movement : public QObject {
  Q_OBJECT

 public:
  Movement(Controls& controls, QObject* parent);

  /// Sets `values`, by name. `more`: further changes follow; of those that follow each other fast, only the
  /// newest is sent. Changes within a second, such as those of a key that is held, are one gesture, too.
  /// Returns whether a new gesture begins.
  bool send(const nlohmann::json& values, bool more);
  /// The movement is over; what waits is sent.
  void end();
  /// The same; the next change is of another movement, however soon it comes.
  void beginNextMovement();
  /// Whether further changes follow.
  bool goesOn() const { return moving_; }

 private:
  Controls& controls_;
  QElapsedTimer last_;                   // since the last change
  bool moving_ = false;                  // further changes of the movement follow
  std::string gesture_;                  // of the movement that goes on; empty: none
  QTimer pause_;                         // runs for a moment after each change of a movement
  std::optional<nlohmann::json> waits_;  // the newest values meanwhile
};

}  // namespace gluray::panel
