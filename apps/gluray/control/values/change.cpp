#include "control/values/change.h"

#include "control/one_program.h"
#include "control/values/setting_values.h"
#include "say.h"
#include "settings/setting_options.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <stdexcept>

namespace gluray::launcher {
namespace {

using nlohmann::json;

/// Adds what the command line asks for to `values`. Returns what is wrong with it; empty: nothing.
std::string addChanges(const CommandLine& line, json& values) {
  for (const std::string& pair : line.control.values) {
    if (std::string why = problemOfPair(pair); !why.empty()) return why;
    const size_t sign = pair.find('=');
    const std::string name = pair.substr(0, sign);
    values[name] = sentValue(name, pair.substr(sign + 1));
  }
  for (const std::string& name : line.control.resets) {
    if (!findSetting(name)) return unknownSetting(name);
    values[name] = nullptr;
  }
  if (!line.control.preset.empty()) values["preset"] = line.control.preset;
  return values.empty() ? "no setting given; use gluray set NAME=VALUE" : "";
}

/// "from frame 1042", "from its next frame"; with the ranks that were late.
std::string whenText(const json& result) {
  const auto frame = result.find("frame");
  const bool known = frame != result.end() && frame->is_number_integer();
  std::string text = known ? "from frame " + frame->dump() : "from its next frame";
  const auto late = result.find("late");
  if (late == result.end() || !late->is_array() || late->empty()) return text;
  std::string ranks;
  for (const json& rank : *late) ranks += (ranks.empty() ? "" : ", ") + rank.dump();
  return text + " (later on rank " + ranks + ")";
}

/// For the chosen programs.
int change(const CommandLine& line, const json& request) {
  HubSession hub(line);
  return sendChange(line, hub, hub.chosen(), request);
}

}  // namespace

int sendChange(const CommandLine& line, HubSession& hub, const std::vector<RunningProgram>& programs,
               json request) {
  request["program"] = numbersOf(programs);
  const json answer = hub.ask(request);
  json list = json::array();
  bool failed = false;
  forEachResult(answer, programs, [&](const RunningProgram& program, const json& result) {
    const std::string why = whyFailed(result);
    failed = failed || !why.empty();
    json one = named(program);
    if (why.empty())
      one["frame"] = result.value("frame", json()), one["values"] = result.value("values", json::object());
    else
      one["why"] = why;
    if (result.contains("late")) one["late"] = result["late"];
    list.push_back(one);
    if (!why.empty())
      say(labelOf(program) + ": " + why);
    else if (!line.json)
      std::cout << labelOf(program) << ": " << valuesText(one["values"]) << " " << whenText(result) << "\n";
  });
  if (line.json) std::cout << jsonText(list) << "\n";
  return failed ? 1 : 0;
}

int changeSettings(const CommandLine& line) {
  json values = json::object();
  if (const std::string why = addChanges(line, values); !why.empty()) return say(why), kUsageError;
  return changeValues(line, values);
}

int changeValues(const CommandLine& line, const json& values) {
  return change(line, {{"type", "set"}, {"values", values}});
}

int stepBackOrForth(const CommandLine& line) {
  return change(line, {{"type", line.command == Command::undo ? "undo" : "redo"}});
}

}  // namespace gluray::launcher
