#include "intercept/session.h"

#include "base/files.h"
#include "base/log.h"
#include "base/timeline.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace gluray::intercept {
namespace {

/// Processes that the launcher did not start keep quiet unless they log to a file.
bool mayTalk(const Session& session) { return !session.logFile.empty() || launchedProcess(); }

log::Level levelOf(const std::string& name) {
  static const std::vector<std::string> names = {"trace", "debug", "info", "warning", "error", "off"};
  const auto it = std::find(names.begin(), names.end(), name);
  return it == names.end() ? log::Level::warning : static_cast<log::Level>(it - names.begin());
}

const Session* readSession() {
  static std::vector<std::string> complaints;
  const auto* session =
      new Session(sessionFromEnvironment([](const std::string& line) { complaints.push_back(line); }));
  log::configure(mayTalk(*session) ? levelOf(session->logLevel) : log::Level::off, session->logFile);
  for (const std::string& line : complaints) log::write(log::Level::warning, line);
  complaints.clear();
  if (!session->timelineFile.empty()) timeline::record(fileOfThisProcess(session->timelineFile));
  return session;
}

}  // namespace

bool launchedProcess() {
  const char* launched = std::getenv("GLURAY_PID");
  return !launched || std::to_string(getpid()) == launched;
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

}  // namespace gluray::intercept
