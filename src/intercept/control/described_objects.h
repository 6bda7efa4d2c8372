// Objects, lights and cameras of a frame as JSON (docs/control-protocol.md, What the program draws). Control
// thread.
#pragma once
#include "intercept/control/shown_scene.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace gluray::intercept {

/// Three numbers.
nlohmann::json arrayOf(const glm::dvec3& v);

/// All objects, in the order of their numbers. Those that several passes draw are described by the first pass
/// in which lights act on them.
std::vector<nlohmann::json> describeObjects(const std::vector<ShownView>& views);

/// The lights of the largest view that shows a lit surface. Throws std::runtime_error.
nlohmann::json describeLights(const std::vector<ShownView>& views);

/// One a view. Throws std::runtime_error.
nlohmann::json describeCameras(const std::vector<ShownView>& views);

}  // namespace gluray::intercept
