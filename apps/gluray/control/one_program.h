// Requests of single programs: calls, settings. For commands, after they have chosen programs.
#pragma once
#include "control/hub_session.h"

#include <nlohmann/json.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace gluray::launcher {

/// The one program that the command is about. Throws where several are chosen, or none.
RunningProgram oneProgram(HubSession& hub);

/// The program's result. Throws std::runtime_error with its reason if it failed.
nlohmann::json resultOf(HubSession& hub, const RunningProgram& program, nlohmann::json request);

/// The object that a call of the program returns; an empty one if it returns something else. Throws
/// std::runtime_error with the program's reason.
nlohmann::json callOf(HubSession& hub, const RunningProgram& program, const char* name,
                      const nlohmann::json& arguments);

/// What the program says of settings by name: {"ao": {"value": true, "layer": "live", "place": ""}}. Throws.
nlohmann::json describedIn(HubSession& hub, const RunningProgram& program,
                           const std::vector<std::string>& names);

/// Their values by name. Throws.
nlohmann::json valuesIn(HubSession& hub, const RunningProgram& program,
                        const std::vector<std::string>& names);

/// {"program": 1, "name": "paraview", "pid": 4242}, to which commands add what they found.
nlohmann::json named(const RunningProgram& program);

/// What `act` returns; std::runtime_error gets the program's name in front.
template <class Act>
auto labelled(const RunningProgram& program, const Act& act) {
  try {
    return act();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(labelOf(program) + ": " + error.what());
  }
}

}  // namespace gluray::launcher
