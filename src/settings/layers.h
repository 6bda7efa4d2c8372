// Where settings come from: layers, of which later ones win, with the origin of every value. GL thread, once
// a process; and the launcher.
#pragma once
#include "settings/rows.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gluray {

enum class Layer : uint8_t {
  builtIn,
  system,       // /etc/gluray/gluray.toml
  user,         // ~/.config/gluray/gluray.toml, or what GLURAY_CONFIG names
  project,      // gluray.toml of the directory where gluray was started
  program,      // [program.NAME] in any of these files
  environment,  // GLURAY_THREADS ...
  commandLine,  // options of the launcher
  live,         // changes at run time
};
inline constexpr size_t kLayerCount = 8;
/// "built-in", "system", ...
std::string_view nameOf(Layer layer);

/// A value that a layer gives.
struct Given {
  const Row* row;
  Layer layer;
  std::string value;
  std::string place;  // "/etc/gluray/gluray.toml:3", "GLURAY_BVH", "--bvh"
};

/// All values that were given, later ones winning, and the session that they make.
struct Layers {
  Session session;
  std::vector<Given> given;
  /// Null where the setting has its built-in value.
  const Given* last(const Row& row) const;
};

/// What the layers are read from.
struct Sources {
  std::string systemFile, userFile, projectFile;
  bool userFileNamed = false;         // by $GLURAY_CONFIG or --config: it has to be there
  std::vector<std::string> programs;  // names of profiles that apply, later ones winning
  /// Name and value of options. Inside the program the launcher has put them into variables, too; then those
  /// of which the variable has another value by now are left out.
  std::vector<std::pair<std::string, std::string>> commandLine;
  bool passed = false;  // by the launcher, in variables
};

/// Those of this process: the environment, the working directory and the executable's name decide.
Sources sourcesOfProcess();

/// gluray.toml of the working directory; empty where that is unknown.
std::string projectFileHere();

/// What cannot be read is reported through `complain`, one line each ("gluray.toml:3: bvh = quick: use auto,
/// fast, full, compact or least"), and left out.
Layers readLayers(const Sources& sources, Complain complain);

}  // namespace gluray
