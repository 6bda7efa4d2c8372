#include "intercept/control/link.h"

#include "base/log.h"
#include "control/link/program_link.h"
#include "control/link/registration.h"
#include "control/runtime_directory.h"
#include "intercept/control/engine_program.h"
#include "intercept/session/guarded.h"
#include "intercept/session/session.h"
#include "settings/live/live_settings.h"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string>

namespace gluray::intercept {
namespace {

std::atomic<LiveSettings*> g_live{nullptr};

/// Never destroyed: programs draw while they exit.
struct Link {
  EngineProgram program;
  control::ProgramLink link;
  explicit Link(LiveSettings& live)
      : link(
            program, live, settingsSource(),
            {session().hub.empty() ? control::runtimeDirectory() : "", session().hub, session().hubKeyFile}) {
  }
};
std::atomic<Link*> g_link{nullptr};
std::atomic<bool> g_tried{false}, g_triedWindow{false};  // the file was written or cannot be; with a window

Link& link() {
  static Link* const once = [] {
    auto* const made = new Link(*g_live);
    g_link = made;
    return made;
  }();
  return *once;
}

std::atomic<const std::string*> g_file{nullptr};  // the file that was left
std::mutex g_writing;

void removeFile() {
  if (!isForkedChild()) unlink(g_file.load()->c_str());
}

void writeFile(const ShownWindow& window) {
  const std::lock_guard lock(g_writing);
  if (window.window == 0 && g_triedWindow) return;
  const std::string directory = control::runtimeDirectory();
  const std::string why =
      control::leaveRegistration(directory, {programName(), window.display, window.window});
  if (!why.empty()) return log::write(log::Level::debug, "hubs will not find this program: " + why);
  if (g_file) return;
  g_file = new std::string(control::registrationFile(directory));  // never destroyed
  std::atexit(removeFile);
}

}  // namespace

void allowControl(LiveSettings& live) noexcept { g_live = &live; }

bool mayBeControlled() noexcept { return g_live.load(std::memory_order_relaxed); }

void lookForHub(double now) noexcept {
  if (!mayBeControlled() || isForkedChild()) return;
  try {
    link().link.lookForHub(now);
  } catch (const std::exception&) {}  // out of memory: retried at the next frame
}

void leaveFile(const ShownWindow& window) noexcept {
  if ((window.window != 0 ? g_triedWindow : g_tried).exchange(true)) return;
  try {
    writeFile(window);
  } catch (const std::exception&) {}  // out of memory: hubs find the program when it draws
}

void leaveHubToParent() noexcept {
  if (Link* const made = g_link) made->link.forked();
}

}  // namespace gluray::intercept
