#include "control/panel.h"

#include "control/hub_session.h"
#include "programs/doors.h"
#include "say.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace gluray::launcher {
namespace {

constexpr const char* kPanel = "gluray-panel";

/// Beside this executable; in a build tree beside its folder; otherwise on the PATH.
std::string panelProgram() {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(launcherFile()).parent_path();
  for (const fs::path& place : {folder / kPanel, folder.parent_path() / "panel" / kPanel})
    if (access(place.c_str(), X_OK) == 0) return place;
  return kPanel;
}

}  // namespace

int becomePanel(std::vector<std::string> words) {
  const std::string program = panelProgram();
  words.insert(words.begin(), program);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(program.c_str(), arguments.data());
  if (errno == ENOENT)
    say("gluray-panel is missing; install the package gluray-panel, or build GLuRay where Qt 6 is installed");
  else
    say(program + ": " + std::strerror(errno));
  return 1;
}

int openPanel(const CommandLine& line) {
  std::vector<std::string> words;
  const control::HubAddress address = addressOf(line);
  if (!address.host.empty()) words = {"--hub", address.host, "--key", address.keyFile};
  return becomePanel(std::move(words));
}

}  // namespace gluray::launcher
