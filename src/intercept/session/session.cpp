#include "intercept/session/session.h"

#include "base/clock.h"
#include "base/files.h"
#include "base/log.h"
#include "base/log_filter.h"
#include "base/timeline.h"
#include "control/link/job.h"
#include "control/link/said_once.h"
#include "settings/live/live_settings.h"

#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace gluray::intercept {
namespace {

static_assert(static_cast<int>(LogLevel::off) == static_cast<int>(log::Level::off));

/// Whether this process may log. Processes that the launcher did not start log only to a file.
bool mayTalk(const Session& session) { return !session.logFile.empty() || launchedProcess(); }

LiveSettings* g_liveSettings = nullptr;  // set after the session was read
std::atomic<void (*)(double) noexcept> g_look{nullptr};

const Session* readSession() {
  static std::vector<std::string> complaints;  // before the log is configured
  static bool logs = false;
  static auto* const live = new LiveSettings(settingsSource(), [](const std::string& line) {
    logs ? log::write(log::Level::warning, line) : complaints.push_back(line);
  });  // never destroyed: programs call OpenGL while they exit
  const auto* session = new Session(live->start(sourcesOfProcess()));
  log::configure(mayTalk(*session) ? static_cast<log::Level>(session->logLevel) : log::Level::off,
                 session->logFile);
  log::filterBy(control::saysLineHere);
  for (const std::string& line : complaints) log::write(log::Level::warning, line);
  complaints.clear();
  logs = true;
  settingsSource().watch([]() noexcept {
    const double now = nowSeconds();
    live->readIfChanged(now);
    if (const auto look = g_look.load(std::memory_order_acquire)) look(now);
  });
  g_liveSettings = live;
  if (!session->timelineFile.empty()) timeline::record(fileOfThisProcess(session->timelineFile));
  return session;
}

}  // namespace

bool launchedProcess() {
  const char* launched = std::getenv("GLURAY_PID");
  return !launched || std::to_string(getpid()) == launched;
}

std::string programName() {
  constexpr size_t kMaxNameBytes = 200;
  const char* const launched = std::getenv("GLURAY_PID");
  const char* const typed = std::getenv("GLURAY_PROGRAM");
  if (launched && typed && *typed && std::to_string(getpid()) == launched)
    return std::filesystem::path(typed).filename().string().substr(0, kMaxNameBytes);
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "" : path.filename().string().substr(0, kMaxNameBytes);
}

std::string fileOfThisProcess(std::string path) {
  if (launchedProcess() || files::isStream(path) || !files::obstacle(path).empty()) return path;
  if (!files::claim(path)) path.append(".").append(std::to_string(getpid()));
  return path;
}

const Session& session() {
  static const Session* const once = readSession();
  return *once;
}

SettingsSource& settingsOfNow() {
  session();
  return settingsSource();
}

LiveSettings& liveSettings() {
  session();
  return *g_liveSettings;
}

void whenFramesBegin(void (*look)(double now) noexcept) noexcept {
  g_look.store(look, std::memory_order_release);
}

bool mayBeSeenByHubs() {
  return session().control && (mayTalk(session()) || control::jobOfThisProcess().ranks > 1);
}

}  // namespace gluray::intercept
