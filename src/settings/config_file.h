// gluray.toml: settings for every run, or for all runs of a program ([program.NAME]). Any thread.
#pragma once
#include "settings/settings.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gluray {

/// One setting as a file has it.
struct FileSetting {
  std::string program;  // whose profile it is in; empty: it is for all
  std::string name, value;
  size_t line = 0;
  std::string wrong;  // why there is no value; empty: there is one
};

enum class Absent : uint8_t { ignored, reported };
/// Whether a file that somebody else owns or may write is read.
enum class Trust : uint8_t { any, ownOnly };

/// The settings of a file in the order of its lines; none where `file` is empty. What keeps it from being
/// read is reported through `complain` in one line.
std::vector<FileSetting> readConfigFile(const std::string& file, Absent absent, Trust trust,
                                        Complain complain);

/// $GLURAY_CONFIG, or gluray/gluray.toml in $XDG_CONFIG_HOME (~/.config where that is unset). Empty: nowhere.
std::string userConfigFile();

}  // namespace gluray
