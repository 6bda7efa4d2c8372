// Objects, lights and cameras of a frame as JSON (docs/control-protocol.md, What the program draws). Control
// thread.
#pragma once
#include "intercept/control/shown_scene.h"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace gluray::intercept {

/// The components as a JSON array.
nlohmann::json arrayOf(const glm::dvec3& v);

/// Describes all objects, in the order of their numbers. An object that several passes draw is described by
/// the first pass in which it is lit.
std::vector<nlohmann::json> describeObjects(const std::vector<ShownView>& views);

/// Describes the lights of the largest view that shows a lit surface. Throws std::runtime_error.
nlohmann::json describeLights(const std::vector<ShownView>& views);

/// Describes the camera of each view. Throws std::runtime_error.
nlohmann::json describeCameras(const std::vector<ShownView>& views);

}  // namespace gluray::intercept
