// What `gluray explain` prints, from the reports of the engine.
#pragma once
#include <nlohmann/json.hpp>

#include <string>

namespace gluray::launcher {

/// The whole text for one process's report.
std::string explanationText(const nlohmann::json& report);

/// Of the triangles in a report, the share that was traced, in percent; -1 where there are none.
double tracedPercent(const nlohmann::json& report);

}  // namespace gluray::launcher
