// Presets: named sets of settings, shipped (spec/presets.toml) or in tables [presets.NAME] of gluray.toml.
// Any thread.
#pragma once
#include "settings/layers/config_file.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gluray {

/// The settings of a file; only those in presets are used.
struct PresetSource {
  std::string file;
  std::span<const FileSetting> settings;
};

/// A value in a preset.
struct PresetValue {
  std::string name, value;
  std::string place;  // "draft, shipped"; "draft, /etc/gluray/gluray.toml:3"
  std::string wrong;  // error, with the place; empty: `value` is text for the setting
};

struct Preset {
  std::string name, help;
  std::vector<PresetValue> values;  // later ones override earlier ones of the same name
};

/// All presets, in the order of their first occurrence: shipped ones, then those of the files. A file adds
/// values to an earlier preset of the same name.
std::vector<Preset> allPresets(std::span<const PresetSource> files);

/// The preset of that name; null if there is none.
const Preset* findPreset(std::string_view name, std::span<const Preset> presets);

/// Why the setting `preset` may not have this value: "there is no such preset; did you mean 'draft'?". Empty
/// if it may.
std::string whyNoPreset(std::string_view name, std::span<const Preset> presets);

}  // namespace gluray
