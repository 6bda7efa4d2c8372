// Reads gluray.toml: settings for every run, or for all runs of one program ([program.NAME]). Any thread.
#pragma once
#include "settings/settings.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gluray {

/// One setting in a file.
struct FileSetting {
  std::string program;  // the program whose profile it is in; empty: for all
  std::string name, value;
  size_t line = 0;
  std::string wrong;  // error; empty: `value` is valid text
};

enum class Absent : uint8_t { ignored, reported };
/// ownOnly: refuses files that somebody else owns or may write.
enum class Trust : uint8_t { any, ownOnly };

/// The settings of a file in line order; none if `file` is empty. If the file cannot be read, reports one
/// line through `complain`.
std::vector<FileSetting> readConfigFile(const std::string& file, Absent absent, Trust trust,
                                        Complain complain);

/// $GLURAY_CONFIG, or gluray/gluray.toml in $XDG_CONFIG_HOME (~/.config if unset). Empty: none.
std::string userConfigFile();

}  // namespace gluray
