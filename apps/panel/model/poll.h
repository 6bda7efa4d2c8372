// Asks the shown program the same call once a second while somebody looks. GUI thread; never waits.
#pragma once
#include "model/calls.h"

#include <QObject>
#include <QTimer>

namespace gluray::panel {

class Controls;

class Poll : public QObject {
  Q_OBJECT

 public:
  /// `name`: of the call, which has no arguments.
  Poll(Controls& controls, const char* name, QObject* parent);
  void watch(bool on);

 signals:
  void answered(const gluray::panel::CallAnswer& answer);
  /// Another program is shown, or none: earlier answers are no longer true.
  void restarted();

 private:
  void restart();
  void ask();

  Controls& controls_;
  const char* const name_;
  QTimer timer_;
  int program_ = 0;
  uint64_t round_ = 0;  // answers of earlier rounds do not count
  bool watched_ = false, underWay_ = false;
};

}  // namespace gluray::panel
