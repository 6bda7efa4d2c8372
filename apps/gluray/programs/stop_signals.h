// Ctrl-C and SIGTERM end the program that the launcher watches, not the launcher. One object at a time.
#pragma once
#include <signal.h>

namespace gluray::launcher {

class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  /// Whether one has come since the object was made.
  static bool stopped();

 private:
  struct sigaction interrupt_ {
  }, terminate_{};
};

}  // namespace gluray::launcher
