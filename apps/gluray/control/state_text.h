// A program's state, and the settings of an event, as text.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace gluray::launcher {

/// "frame 1042, 24.0 fps, 1 000 000 triangles, 98.5 % traced, 512 MB, noise 0.012, 14 passes". Members that
/// are missing or no numbers are left out.
std::string stateText(const nlohmann::json& state);

}  // namespace gluray::launcher
