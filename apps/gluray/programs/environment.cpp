#include "programs/environment.h"

#include "programs/doors.h"
#include "say.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <map>
#include <string_view>

namespace gluray::launcher {
namespace {

using Variables = std::map<std::string, std::string>;

/// Of the process that the launcher becomes. Here nobody knows which process that will be.
constexpr std::string_view kOfOneProcess[] = {"GLURAY_PID", "GLURAY_STREAMS", "GLURAY_PROGRAM"};

Variables variablesOfProcess() {
  Variables variables;
  for (char** entry = environ; entry && *entry; ++entry) {
    const std::string_view text = *entry;
    if (const size_t sign = text.find('='); sign != text.npos)
      variables.emplace(text.substr(0, sign), text.substr(sign + 1));
  }
  for (const std::string_view name : kOfOneProcess) variables.erase(std::string(name));
  return variables;
}

/// Those that differ from `before`.
Variables changedSince(const Variables& before) {
  Variables changed;
  for (const auto& [name, value] : variablesOfProcess())
    if (const auto old = before.find(name); old == before.end() || old->second != value)
      changed[name] = value;
  return changed;
}

/// A word of a POSIX shell.
std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) c == '\'' ? word += "'\\''" : word += c;
  return word += "'";
}

/// The doors that a process can still load: libglvnd and programs then find them by their DT_SONAMEs. Our
/// libOSMesa, too: what it draws comes through EGL.
nlohmann::json librariesFor(const Variables& variables) {
  namespace fs = std::filesystem;
  nlohmann::json libraries = nlohmann::json::array();
  const std::string directory = libraryDirectory();
  const auto add = [&](const char* variable, const char* file) {
    std::error_code error;
    const fs::path path = fs::path(directory) / file;
    if (variables.contains(variable) && fs::exists(path, error)) libraries.push_back(path.string());
  };
  add("GLURAY_REAL_GLX", "libGLX_gluray.so.0");
  add("GLURAY_REAL_EGL", "libEGL_gluray.so.0");
  add("GLURAY_REAL_EGL", "osmesa/libOSMesa.so.8");
  return libraries;
}

}  // namespace

int printEnvironment(const CommandLine& line) {
  const Variables before = variablesOfProcess();
  CommandLine any = line;
  any.program.clear();  // nothing is known of the programs
  if (const std::string why = openDoors(any, {}); !why.empty()) return say(why), 1;
  const Variables changed = changedSince(before);
  if (line.json) {
    const nlohmann::json all{
        {"variables", changed}, {"libraries", librariesFor(changed)}, {"program", line.program}};
    std::cout << jsonText(all) << "\n";
    return 0;
  }
  for (const auto& [name, value] : changed) std::cout << "export " << name << "=" << quoted(value) << "\n";
  return 0;
}

}  // namespace gluray::launcher
