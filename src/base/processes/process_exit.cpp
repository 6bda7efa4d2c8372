#include "base/processes/process_exit.h"

#include <atomic>
#include <cstdlib>

namespace gluray {
namespace {

std::atomic<bool> g_exiting{false};

}  // namespace

void watchForExit() noexcept {
  std::atexit([] { g_exiting = true; });
}

bool isExiting() noexcept { return g_exiting; }

}  // namespace gluray
