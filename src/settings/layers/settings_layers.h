// Layers of settings: later layers override earlier ones, and every value has its origin. Read by the
// process, when it starts and when files change (settings/live/live_settings.h), and by the launcher. Any
// thread.
#pragma once
#include "settings/layers/config_file.h"
#include "settings/layers/presets.h"
#include "settings/rows.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gluray {

enum class Layer : uint8_t {
  builtIn,
  system,       // /etc/gluray/gluray.toml
  user,         // ~/.config/gluray/gluray.toml, or the file that GLURAY_CONFIG names
  project,      // gluray.toml of the directory in which gluray was started
  program,      // the profile that is shipped for the program; [program.NAME] in any of these files
  preset,       // the preset that the setting `preset` names
  environment,  // GLURAY_THREADS ...
  commandLine,  // options of the launcher
  live,         // changes at run time
};
inline constexpr size_t kLayerCount = 9;
/// "built-in", "system", ...
std::string_view nameOf(Layer layer);

/// A value from one layer.
struct Given {
  const Row* row;
  Layer layer;
  std::string value;
  std::string place;  // "/etc/gluray/gluray.toml:3", "GLURAY_BVH", "--bvh"
};

/// All given values in order of precedence, highest last, and the resulting session.
struct Layers {
  Session session;
  std::vector<Given> given;
  /// The value in effect; null if the setting has its built-in value.
  const Given* last(const Row& row) const;
};

/// The inputs of the layers.
struct Sources {
  std::string systemFile, userFile, projectFile;
  bool userFileNamed = false;         // by $GLURAY_CONFIG or --config: it must exist
  std::vector<std::string> programs;  // names of the profiles that apply, highest precedence last
  /// Names and values of options. If `passed`, values come from the variables that the launcher set, and this
  /// list says which of these are options. A variable that has changed since is not one.
  std::vector<std::pair<std::string, std::string>> commandLine;
  bool passed = false;  // the launcher passed the options in variables
  /// Names and values of variables; nullopt: those of the process when the layers are read.
  std::optional<std::vector<std::pair<std::string, std::string>>> variables;
  std::vector<std::pair<std::string, std::string>> live;  // names and values
};

/// The sources of this process, from its environment, working directory and executable name.
Sources sourcesOfProcess();

/// Path of gluray.toml in the working directory; empty if that is unknown.
std::string projectFileHere();

/// The settings of one file.
struct ConfigFile {
  Layer layer;
  std::string path;
  std::vector<FileSetting> settings;
};
using ConfigFiles = std::array<ConfigFile, 3>;  // system, user, project

/// Reads the files. Reports files that cannot be read through `complain`, one line each.
ConfigFiles readConfigFiles(const Sources& sources, const Complain& complain);

/// All presets: shipped ones, and those of the files.
std::vector<Preset> presetsOf(const ConfigFiles& files);

/// Combines the layers. Skips wrong entries and reports them through `complain`, one line each
/// ("gluray.toml:3: bvh = quick: use auto, fast, full, compact or least").
Layers layersOf(const Sources& sources, const ConfigFiles& files, const Complain& complain);

/// Reads the files and combines the layers.
Layers readLayers(const Sources& sources, const Complain& complain);

}  // namespace gluray
