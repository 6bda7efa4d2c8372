// Turns the engine's report into the text that `gluray explain` prints.
#pragma once
#include <nlohmann/json.hpp>

#include <string>

namespace gluray::launcher {

/// The whole text for one process's report.
std::string explanationText(const nlohmann::json& report);

/// Percentage of a report's triangles that were traced; -1 if it has no triangles.
double tracedPercent(const nlohmann::json& report);

}  // namespace gluray::launcher
