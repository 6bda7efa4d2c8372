#include "view/look.h"

#include "settings/layers/settings_layers.h"

#include <algorithm>

namespace gluray::panel {
namespace {

constexpr const char* kQuality = "quality-";

using Values = std::vector<std::pair<std::string, std::string>>;

void set(const std::string& name, const std::string& value, Values& values) {
  const auto same =
      std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
  if (same == values.end())
    values.emplace_back(name, value);
  else
    same->second = value;
}

void take(const std::string& name, const std::vector<Preset>& presets, Values& values) {
  const Preset* const preset = findPreset(name, presets);
  if (!preset) return;
  for (const PresetValue& value : preset->values)
    if (value.wrong.empty()) set(value.name, value.value, values);
}

QString pair(const std::string& name, const std::string& value) {
  return QString::fromStdString(name + "=" + value);
}

}  // namespace

QStringList LookOptions::words() const {
  QStringList words;
  if (!preset.empty()) words << "--preset" << QString::fromStdString(preset);
  if (!quality.empty()) words << "--quality" << QString::fromStdString(quality);
  for (const auto& [name, value] : values) words << "--set" << pair(name, value);
  return words;
}

std::vector<std::string> LookOptions::settings(const std::vector<Preset>& presets) const {
  Values all;
  if (!preset.empty()) take(preset, presets, all);
  if (!quality.empty()) take(kQuality + quality, presets, all);
  for (const auto& [name, value] : values) set(name, value, all);
  std::vector<std::string> texts;
  for (const auto& [name, value] : all) texts.push_back(name + "=" + value);
  return texts;
}

std::vector<Preset> presetsHere() {
  Sources sources = sourcesOfProcess();
  sources.projectFile = projectFileHere();
  return presetsOf(readConfigFiles(sources, [](const std::string&) {}));
}

bool isQuality(const Preset& preset) { return preset.name.starts_with(kQuality); }

}  // namespace gluray::panel
