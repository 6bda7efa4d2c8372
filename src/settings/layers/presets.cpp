#include "settings/layers/presets.h"

#include "settings/built_in_presets.gen.h"
#include "settings/nearest.h"

#include <toml++/toml.h>

#include <algorithm>

namespace gluray {
namespace {

void collect(const PresetSource& source, std::vector<Preset>& presets) {
  for (const FileSetting& s : source.settings) {
    if (s.section.kind != Section::Kind::preset) continue;
    auto preset = std::find_if(presets.begin(), presets.end(),
                               [&](const Preset& p) { return p.name == s.section.name; });
    if (preset == presets.end()) preset = presets.insert(presets.end(), {s.section.name, "", {}});
    const std::string place = source.file.empty() ? "shipped" : source.file + ":" + std::to_string(s.line);
    if (s.name == "help" && s.wrong.empty())
      preset->help = s.value;
    else
      preset->values.push_back(
          {s.name, s.value, preset->name + ", " + place, s.wrong.empty() ? "" : place + ": " + s.wrong});
  }
}

/// The shipped presets' settings; empty if their text is wrong, which the tests check.
std::vector<FileSetting> shipped() {
  try {
    return readConfigText(kBuiltInPresets);
  } catch (const toml::parse_error&) { return {}; }
}

}  // namespace

std::vector<Preset> allPresets(std::span<const PresetSource> files) {
  std::vector<Preset> presets;
  const std::vector<FileSetting> ours = shipped();
  collect({"", ours}, presets);
  for (const PresetSource& file : files) collect(file, presets);
  return presets;
}

const Preset* findPreset(std::string_view name, std::span<const Preset> presets) {
  const auto found =
      std::find_if(presets.begin(), presets.end(), [&](const Preset& p) { return p.name == name; });
  return found == presets.end() ? nullptr : &*found;
}

std::string whyNoPreset(std::string_view name, std::span<const Preset> presets) {
  if (name.empty() || name == kNoPreset || findPreset(name, presets)) return "";
  std::vector<std::string_view> names{kNoPreset};
  std::string list;
  for (const Preset& preset : presets) {
    names.push_back(preset.name);
    list += preset.name + ", ";
  }
  const std::string_view near = nearest(name, names);
  return "there is no such preset; " +
         (near.empty() ? "use " + list + "or none" : "did you mean '" + std::string(near) + "'?");
}

}  // namespace gluray
