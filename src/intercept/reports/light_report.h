// What reports and controls tell of the refinement of images. Any thread.
#pragma once
#include <nlohmann/json_fwd.hpp>

namespace gluray::intercept {

/// Refinement while the program was idle.
nlohmann::json idleReport();
/// The image that the program waits for; null: none, or not for long.
nlohmann::json progressReport();

}  // namespace gluray::intercept
