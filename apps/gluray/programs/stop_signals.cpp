#include "programs/stop_signals.h"

namespace gluray::launcher {
namespace {

volatile sig_atomic_t g_stop = 0;

}  // namespace

StopSignals::StopSignals() {
  g_stop = 0;
  struct sigaction note {};
  note.sa_handler = [](int) { g_stop = 1; };
  sigaction(SIGINT, &note, &interrupt_);
  sigaction(SIGTERM, &note, &terminate_);
}

StopSignals::~StopSignals() {
  sigaction(SIGINT, &interrupt_, nullptr);
  sigaction(SIGTERM, &terminate_, nullptr);
}

bool StopSignals::stopped() { return g_stop != 0; }

}  // namespace gluray::launcher
