#include "settings/presets_list.h"

#include "base/printable.h"
#include "say.h"
#include "settings/settings_list.h"
#include "text_table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <string_view>

namespace gluray::launcher {
namespace {

nlohmann::json described(const Preset& preset, bool chosen) {
  nlohmann::json values = nlohmann::json::array();
  for (const PresetValue& v : preset.values)
    values.push_back({{"name", v.name}, {"value", v.value}, {"place", v.place}, {"wrong", v.wrong}});
  return {{"name", preset.name}, {"help", preset.help}, {"chosen", chosen}, {"values", values}};
}

void print(const Preset& preset, bool chosen, bool values) {
  std::cout << printable(preset.name) << (chosen ? "  (chosen)" : "") << "\n"
            << wrapped(printable(preset.help), 76, "  ");
  TextTable table("lll");
  for (const PresetValue& v : preset.values)
    table.row({printable(v.name), printable(v.wrong.empty() ? v.value : v.wrong), printable(v.place)});
  if (values) std::cout << table.text("    ");
}

}  // namespace

int listPresets(const CommandLine& line) {
  const Sources sources = sourcesOf(line);
  const Complain complain = [](const std::string& complaint) { say(complaint); };
  const ConfigFiles files = readConfigFiles(sources, complain);
  const std::vector<Preset> all = presetsOf(files);
  // That of a program that starts now.
  const std::string chosen = layersOf(sources, files, complain).session.settings.preset;
  nlohmann::json list = nlohmann::json::array();
  for (const std::string& name : line.names) {
    if (findPreset(name, all)) continue;
    const std::string why = whyNoPreset(name, all);
    return say(printable(name) + ": " + (why.empty() ? "this means no preset" : why)), kUsageError;
  }
  for (const Preset& preset : all) {
    const bool named = std::find(line.names.begin(), line.names.end(), preset.name) != line.names.end();
    if (!line.names.empty() && !named) continue;
    if (line.json)
      list.push_back(described(preset, preset.name == chosen));
    else
      print(preset, preset.name == chosen, named);
  }
  if (line.json) std::cout << jsonText(list) << "\n";
  return 0;
}

std::string wrongPreset(const CommandLine& line) {
  const std::string name = line.settings.find("preset");
  if (name.empty()) return "";
  const ConfigFiles files = readConfigFiles(sourcesOf(line), [](const std::string&) {});
  const std::string why = whyNoPreset(name, presetsOf(files));
  return why.empty() ? "" : "--preset " + printable(name) + ": " + why;
}

}  // namespace gluray::launcher
