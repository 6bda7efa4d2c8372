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
#include <sstream>
#include <string>
#include <string_view>
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

/// The value with its unit, or with what it means if it is the least one: "30 degrees", "0 (all cores)".
std::string shownWithUnit(const Row& row, const Session& session) {
  const std::string text = printValue(row, session);
  const json value = control::valueOf(row, text);
  if (!value.is_number()) return shown(text);
  if (!row.leastMeans.empty() && value.get<double>() == row.least)
    return text + " (" + std::string(row.leastMeans) + ")";
  return row.unit.empty() ? text : text + " " + std::string(row.unit);
}

std::string originOf(const Given* given) {
  return given ? std::string(nameOf(given->layer)) + ": " + printable(given->place) : "built-in";
}

bool isChanged(const Layers& layers, const Row& row) { return !sameValue(row, layers.session, Session{}); }

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
            << originOf(layers.last(row)) << ")\n\n  " << row.title << " (" << row.group << ", "
            << nameOf(row.level) << ")\n"
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
    if (line.names.empty() && isChanged(layers, row)) rows.push_back(&row);
  return rows;
}

/// Whether the list of `gluray settings` has the setting.
bool isListed(const CommandLine& line, const Layers& layers, const Row& row) {
  return line.changed ? isChanged(layers, row) : line.all || row.level == Level::basic;
}

/// The listed settings below the names of their groups; columns are aligned over all groups.
void printGroups(const CommandLine& line, const Layers& layers) {
  TextTable table("llll");
  std::vector<std::string_view> groups;  // of the table's rows
  for (const std::string_view group : settingGroups())
    for (const Row* row : rowsOfGroup(group)) {
      if (!isListed(line, layers, *row)) continue;
      groups.push_back(group);
      table.row({std::string(row->title), std::string(row->name), shownWithUnit(*row, layers.session),
                 originOf(layers.last(*row))});
    }
  std::istringstream lines(table.text("  "));
  std::string one;
  for (size_t i = 0; std::getline(lines, one); ++i) {
    if (i == 0 || groups[i] != groups[i - 1]) std::cout << groups[i] << "\n";
    std::cout << one << "\n";
  }
  if (const size_t more = settingRows().size() - groups.size(); more > 0 && !line.changed)
    std::cout << more << " more settings: gluray settings --all\n";
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
  if (!line.json) return printGroups(line, layers), 0;
  json list = json::array();
  for (const Row& row : settingRows())
    if (!line.changed || isChanged(layers, row)) list.push_back(describe(layers, row));
  std::cout << jsonText(list) << "\n";
  return 0;
}

}  // namespace gluray::launcher
