#include "control/one_program.h"

#include "control/messages/members.h"

namespace gluray::launcher {

using nlohmann::json;

json resultOf(HubSession& hub, const RunningProgram& program, json request) {
  request["program"] = numbersOf({program});
  json found;
  forEachResult(hub.ask(request), {program}, [&](const RunningProgram&, const json& result) {
    if (const std::string why = whyFailed(result); !why.empty()) throw std::runtime_error(why);
    found = result;
  });
  return found;
}

RunningProgram oneProgram(HubSession& hub) {
  const std::vector<RunningProgram> programs = hub.chosen();
  if (programs.size() > 1) throw std::runtime_error("several programs run; choose one with -p");
  return programs.front();
}

json callOf(HubSession& hub, const RunningProgram& program, const char* name, const json& arguments) {
  const json result = resultOf(hub, program, {{"type", "call"}, {"name", name}, {"arguments", arguments}});
  const json value = result.value("value", json());
  return value.is_object() ? value : json::object();
}

json describedIn(HubSession& hub, const RunningProgram& program, const std::vector<std::string>& names) {
  const json result = resultOf(hub, program, {{"type", "get"}, {"names", names}});
  const json all = result.value("values", json());
  json found = json::object();
  for (const std::string& name : names) {
    const json* const one = control::member(all, name.c_str());
    if (!one || !control::member(*one, "value"))
      throw std::runtime_error("it does not say what " + name + " is");
    found[name] = *one;
  }
  return found;
}

json valuesIn(HubSession& hub, const RunningProgram& program, const std::vector<std::string>& names) {
  json values = json::object();
  const json described = describedIn(hub, program, names);
  for (const auto& [name, one] : described.items()) values[name] = one["value"];
  return values;
}

json named(const RunningProgram& program) {
  return {{"program", program.number}, {"name", program.name}, {"pid", program.pid}};
}

}  // namespace gluray::launcher
