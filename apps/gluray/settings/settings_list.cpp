#include "settings/settings_list.h"

#include "base/printable.h"
#include "control/messages/value.h"
#include "control/values/setting_values.h"
#include "say.h"
#include "settings/values.h"
#include "text_table.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace gluray::launcher {
namespace {

using nlohmann::json;

// In text; in JSON it is "frame", "context" or "process".
constexpr std::string_view kApplies[] = {"from the next frame on", "to contexts made afterwards",
                                         "to the next run"};

Layers layersFor(const CommandLine& line) {
  return readLayers(sourcesOf(line), [](const std::string& complaint) { say(complaint); });
}

std::string shown(const std::string& value) { return value.empty() ? "-" : printable(value); }

std::string originOf(const Given* given) {
  return given ? std::string(nameOf(given->layer)) + ": " + printable(given->place) : "built-in";
}

/// As programs describe their settings (control::description), with the value.
json describe(const Layers& layers, const Row& row) {
  const Given* given = layers.last(row);
  json one = control::description(row);
  one["value"] = control::valueOf(row, printValue(row, layers.session));
  one["layer"] = nameOf(given ? given->layer : Layer::builtIn);
  one["place"] = given ? given->place : "";
  return one;
}

void printWhy(const Layers& layers, const Row& row) {
  std::cout << row.name << " = " << shown(printValue(row, layers.session)) << "  ("
            << originOf(layers.last(row)) << ")\n\n"
            << wrapped(std::string(row.help) + " " + std::string(row.more), 76, "  ");
  for (const Word& word : row.words)
    if (!word.help.empty())
      std::cout << wrapped(std::string(word.word) + ": " + std::string(word.help), 72, "    ");
  const std::string allowed = allowedValues(row);
  std::cout << wrapped((allowed.empty() ? "" : "Values: " + allowed + ". ") +
                           "Default: " + shown(printValue(row, Session{})) + ". A change applies " +
                           std::string(kApplies[static_cast<size_t>(row.applies)]) + ".",
                       76, "  ")
            << "\n";
  TextTable table("lll");
  for (const json& layer : control::layersOf(layers, row))
    table.row({layer["layer"], valueText(std::string(row.name), layer["value"]),
               printable(layer["place"].get<std::string>())});
  std::cout << table.text("  ");
}

json all(const Layers& layers, const Row& row) {
  json one = describe(layers, row);
  one["layers"] = control::layersOf(layers, row);
  return one;
}

int explainOne(const CommandLine& line, const Layers& layers) {
  const Row* row = findSetting(line.why);
  if (!row) return say(unknownSetting(line.why)), kUsageError;
  if (!line.json) return printWhy(layers, *row), 0;
  std::cout << jsonText(all(layers, *row)) << "\n";
  return 0;
}

/// The rows that the command line names; all that differ from their built-in values if it names none.
std::vector<const Row*> wanted(const CommandLine& line, const Layers& layers) {
  std::vector<const Row*> rows;
  for (const std::string& name : line.names) rows.push_back(findSetting(name));
  for (const Row& row : settingRows())
    if (line.names.empty() && !sameValue(row, layers.session, Session{})) rows.push_back(&row);
  return rows;
}

}  // namespace

Sources sourcesOf(const CommandLine& line) {
  Sources sources = sourcesOfProcess();
  if (!line.config.empty()) sources.userFile = line.config, sources.userFileNamed = true;
  sources.projectFile = projectFileHere();
  sources.programs.clear();
  if (!line.profile.empty())
    sources.programs.push_back(std::filesystem::path(line.profile).filename().string());
  sources.commandLine = passedValues(line.settings);
  sources.passed = false;
  return sources;
}

int getSettings(const CommandLine& line) {
  for (const std::string& name : line.names)
    if (!findSetting(name)) return say(unknownSetting(name)), kUsageError;
  const Layers layers = layersFor(line);
  json list = json::array();
  for (const Row* row : wanted(line, layers)) {
    if (line.json)
      list.push_back(line.layers ? all(layers, *row) : describe(layers, *row));
    else if (line.layers)
      printWhy(layers, *row);
    else if (line.names.size() == 1)
      std::cout << printable(printValue(*row, layers.session)) << "\n";
    else
      std::cout << row->name << " = " << shown(printValue(*row, layers.session)) << "\n";
  }
  if (line.json) std::cout << jsonText(list) << "\n";
  return 0;
}

int listSettings(const CommandLine& line) {
  const Layers layers = layersFor(line);
  if (!line.why.empty()) return explainOne(line, layers);
  json list = json::array();
  TextTable table("lll");
  for (const Row& row : settingRows()) {
    if (line.changed && sameValue(row, layers.session, Session{})) continue;
    list.push_back(describe(layers, row));
    table.row({std::string(row.name), shown(printValue(row, layers.session)), originOf(layers.last(row))});
  }
  std::cout << (line.json ? jsonText(list) + "\n" : table.text(""));
  return 0;
}

}  // namespace gluray::launcher
