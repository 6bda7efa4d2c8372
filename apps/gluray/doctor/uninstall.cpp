#include "doctor/uninstall.h"

#include "base/environment_variable.h"
#include "control/runtime_directory.h"
#include "doctor/host.h"
#include "programs/doors.h"
#include "say.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace gluray::launcher {
namespace {

namespace fs = std::filesystem;

struct Kept {
  std::string path;
  const char* what;
};

/// The user's directory of GLuRay in the one that `variable` names, or in `inHome`; empty if there is none.
std::string userDirectory(const char* variable, const char* inHome) {
  const std::string chosen = environmentVariable(variable), home = environmentVariable("HOME");
  if (!chosen.empty()) return chosen + "/gluray";
  return home.empty() ? "" : home + inHome + "/gluray";
}

std::vector<Kept> keptOutside() {
  std::vector<Kept> kept;
  const auto add = [&](const std::string& path, const char* what) {
    std::error_code error;
    if (path.empty() || !fs::is_directory(fs::symlink_status(path, error)) || error) return;
    for (const Kept& other : kept)
      if (other.path == path) return;
    kept.push_back({path, what});
  };
  add(userDirectory("XDG_CONFIG_HOME", "/.config"), "settings");
  if (const std::string cache = userDirectory("XDG_CACHE_HOME", "/.cache"); !cache.empty())
    add(cache + "/trials", "results of engine = auto");
  std::vector<std::string> runtimes{control::runtimeDirectory()};
  // Links lie there where the session's directory cannot hold them. Who has chosen a directory keeps to it.
  if (environmentVariable("GLURAY_RUNTIME").empty())
    runtimes.push_back("/tmp/gluray-" + std::to_string(getuid()));
  for (const std::string& path : runtimes)
    if (control::whyUnsafe(path).empty()) add(path, "sockets and links of programs that run");
  return kept;
}

/// Removes a directory, and the one around it if that is GLuRay's and empty.
void remove(const fs::path& path, std::error_code& error) {
  fs::remove_all(path, error);
  std::error_code notEmpty;
  if (!error && path.parent_path().filename() == "gluray") fs::remove(path.parent_path(), notEmpty);
}

}  // namespace

int uninstall(const CommandLine& line) {
  const std::string libraries = libraryDirectory();
  const Installed how = howInstalled(libraries);
  const std::vector<Kept> kept = keptOutside();
  nlohmann::json list = nlohmann::json::array();
  bool failed = false;
  for (const Kept& one : kept) {
    std::error_code error;
    if (line.remove) remove(one.path, error);
    if (error) say(one.path + ": " + error.message()), failed = true;
    list.push_back({{"path", one.path}, {"what", one.what}, {"removed", line.remove && !error}});
    if (!line.json)
      std::cout << (line.remove && !error ? "removed: " : "kept: ") << one.path << " (" << one.what << ")\n";
  }
  const std::string itself = adviceToRemove(how, libraries, thisHost());
  if (line.json) {
    std::cout << jsonText({{"outside", list}, {"remove", itself}}) << "\n";
  } else {
    if (kept.empty()) std::cout << "GLuRay keeps nothing outside its own folder\n";
    if (!kept.empty() && !line.remove) std::cout << "gluray uninstall --remove removes them\n";
    std::cout << "GLuRay itself is " << described(how, libraries) << "; to remove it: " << itself << "\n";
  }
  return failed ? 1 : 0;
}

}  // namespace gluray::launcher
