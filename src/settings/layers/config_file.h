// Reads gluray.toml: settings for every run, for all runs of one program ([program.NAME]), and presets
// ([presets.NAME]). Any thread.
#pragma once
#include "settings/settings.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gluray {

/// The name that means no preset.
inline constexpr std::string_view kNoPreset = "none";

/// The part of a file that contains a setting.
struct Section {
  enum class Kind : uint8_t { all, program, preset };
  Kind kind = Kind::all;
  std::string name;  // of the program or preset
  bool operator==(const Section&) const = default;
};

/// One setting in a file. In presets also `help`, a sentence for lists of presets.
struct FileSetting {
  Section section;
  std::string name, value;
  size_t line = 0;
  std::string wrong;  // error; empty: `value` is valid text
};

enum class Absent : uint8_t { ignored, reported };
/// ownOnly: refuses files that another user owns or may write.
enum class Trust : uint8_t { any, ownOnly };

/// The settings of a file, in line order; empty if `file` is empty. If the file cannot be read, reports one
/// line through `complain`.
std::vector<FileSetting> readConfigFile(const std::string& file, Absent absent, Trust trust,
                                        const Complain& complain);

/// The settings of a file's text; throws toml::parse_error.
std::vector<FileSetting> readConfigText(std::string_view text);

/// $GLURAY_CONFIG, or gluray/gluray.toml in $XDG_CONFIG_HOME (~/.config if unset). Empty if there is none.
std::string userConfigFile();

}  // namespace gluray
