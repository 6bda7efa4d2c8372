#include "control/values/live_values.h"

#include "base/printable.h"
#include "control/hub_session.h"
#include "control/messages/value.h"
#include "control/values/setting_values.h"
#include "say.h"
#include "settings/values.h"
#include "text_table.h"

#include <nlohmann/json.hpp>

#include <iostream>

namespace gluray::launcher {
namespace {

using nlohmann::json;

bool isBuiltIn(const std::string& name, const json& described) {
  const Row* row = findSetting(name);
  const json value = described.value("value", json());
  return row ? value == control::valueOf(*row, printValue(*row, Session{})) : value.is_null();
}

/// What a program says of its settings: those that were asked for, or those that differ.
json wantedOf(const json& result, const std::vector<std::string>& names) {
  json wanted = json::object();
  const auto values = result.find("values");
  if (values == result.end() || !values->is_object()) return wanted;
  for (const auto& [name, described] : values->items())
    if (described.is_object() && (!names.empty() || !isBuiltIn(name, described))) wanted[name] = described;
  return wanted;
}

void printLayers(const std::string& name, const json& described) {
  const auto layers = described.find("layers");
  if (layers == described.end() || !layers->is_array()) return;
  TextTable table("lll");
  for (const json& layer : *layers) {
    if (!layer.is_object()) continue;
    const json value = layer.value("value", json()), place = layer.value("place", json());
    const json word = layer.value("layer", json());
    table.row({word.is_string() ? printable(word.get<std::string>()) : "-", valueText(name, value),
               place.is_string() ? printable(place.get<std::string>()) : ""});
  }
  std::cout << table.text("  ");
}

void printValues(const CommandLine& line, const std::string& prefix, const json& values) {
  for (const auto& [name, described] : values.items()) {
    const json value = described.value("value", json());
    if (line.names.size() == 1 && prefix.empty() && !line.layers) {
      const std::string text = valueText(name, value);
      std::cout << (text == "-" ? "" : text) << "\n";
      continue;
    }
    std::cout << prefix << printable(name) << " = " << valueText(name, value);
    if (line.layers) std::cout << "  (" << originText(described) << ")";
    std::cout << "\n";
    if (line.layers) printLayers(name, described);
  }
}

}  // namespace

int getLiveSettings(const CommandLine& line) {
  for (const std::string& name : line.names)
    if (!findSetting(name)) return say(unknownSetting(name)), kUsageError;
  HubSession hub(line);
  const std::vector<RunningProgram> programs = hub.chosen();
  json request = {{"type", "get"}, {"program", numbersOf(programs)}, {"names", line.names}};
  if (line.layers) request["layers"] = true;
  json list = json::array();
  bool failed = false;
  forEachResult(hub.ask(request), programs, [&](const RunningProgram& program, const json& result) {
    const std::string why = whyFailed(result);
    json one = {{"program", program.number}, {"name", program.name}, {"pid", program.pid}};
    if (why.empty())
      one["values"] = wantedOf(result, line.names);
    else
      one["why"] = why, failed = true, say(labelOf(program) + ": " + why);
    if (why.empty() && !line.json)
      printValues(line, programs.size() > 1 ? labelOf(program) + ": " : "", one["values"]);
    list.push_back(std::move(one));
  });
  if (line.json) std::cout << jsonText(list) << "\n";
  return failed ? 1 : 0;
}

}  // namespace gluray::launcher
