#include "intercept/session.h"

#include "base/log.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace gluray::intercept {
namespace {

/// Whether this is the process that the launcher started, or there was no launcher: others keep quiet unless
/// they log to a file.
bool mayTalk(const Session& session) {
  const char* launched = std::getenv("GLURAY_PID");
  return !session.logFile.empty() || !launched || std::to_string(getpid()) == launched;
}

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
  return session;
}

}  // namespace

const Session& session() {
  static const Session* const once = readSession();
  return *once;
}

}  // namespace gluray::intercept
