#include "base/environment_variable.h"
#include "settings/layers/config_file.h"
#include "settings/layers/settings_layers.h"

#include <unistd.h>

#include <filesystem>
#include <sstream>
#include <string_view>

namespace gluray {
namespace {

namespace fs = std::filesystem;

/// The absolute path, because programs may change their working directory.
std::string absolute(const std::string& file) {
  std::error_code error;
  const fs::path whole = file.empty() ? fs::path() : fs::absolute(file, error);
  return error ? file : whole.string();
}

/// The project file in the launcher's working directory or, without a launcher, in this process's.
std::string projectFile() {
  std::string named = environmentVariable("GLURAY_PROJECT");
  return named.empty() ? projectFileHere() : absolute(named);
}

/// The executable's name and, in the process that the launcher became, the name that the user typed.
std::vector<std::string> programNames() {
  std::vector<std::string> names;
  std::error_code error;
  const fs::path executable = fs::read_symlink("/proc/self/exe", error);
  if (!error) names.push_back(executable.filename().string());
  const std::string typed = environmentVariable("GLURAY_PROGRAM");
  const bool launched = environmentVariable("GLURAY_PID") == std::to_string(getpid());
  if (launched && !typed.empty() && (names.empty() || names[0] != typed)) names.push_back(typed);
  return names;
}

/// The variables GLURAY_... and their values.
std::vector<std::pair<std::string, std::string>> variablesOfProcess() {
  std::vector<std::pair<std::string, std::string>> variables;
  for (char** entry = environ; entry && *entry; ++entry) {
    const std::string_view text = *entry;
    const size_t sign = text.find('=');
    if (text.starts_with("GLURAY_") && sign != text.npos)
      variables.emplace_back(text.substr(0, sign), text.substr(sign + 1));
  }
  return variables;
}

/// The options that the launcher passed as lines NAME=VALUE.
std::vector<std::pair<std::string, std::string>> passedOptions() {
  std::vector<std::pair<std::string, std::string>> options;
  std::istringstream lines(environmentVariable("GLURAY_COMMAND_LINE"));
  for (std::string line; std::getline(lines, line);)
    if (const size_t sign = line.find('='); sign != line.npos)
      options.emplace_back(line.substr(0, sign), line.substr(sign + 1));
  return options;
}

}  // namespace

std::string projectFileHere() {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  return error ? "" : (here / "gluray.toml").string();
}

Sources sourcesOfProcess() {
  Sources sources;
  sources.systemFile = "/etc/gluray/gluray.toml";
  sources.userFile = absolute(userConfigFile());
  sources.userFileNamed = !environmentVariable("GLURAY_CONFIG").empty();
  sources.projectFile = projectFile();
  sources.programs = programNames();
  sources.commandLine = passedOptions();
  sources.passed = true;
  sources.variables = variablesOfProcess();
  return sources;
}

}  // namespace gluray
