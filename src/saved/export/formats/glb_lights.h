// Lights as those of the glTF extension KHR_lights_punctual. Any thread.
#pragma once
#include "saved/export/gather/exported_scene.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace gluray::saved {

/// The bounds of a view's surfaces, in world space.
struct WorldBox {
  glm::dvec3 lower{0}, upper{0};
  WorldBox(const ExportedScene&, const ExportedView&);
  glm::dvec3 middle() const { return 0.5 * (lower + upper); }
  double radius() const { return 0.5 * glm::length(upper - lower); }
};

/// The light as files can have it best: one at a place far from the box that does not fade becomes one from a
/// direction.
ExportedLight fileLight(ExportedLight, const WorldBox&);

/// The light, without its place; none if it is black. Its brightness is such that white surfaces that face it
/// have the program's brightness, of lights at places in the middle of the box.
std::optional<nlohmann::json> lightOf(const ExportedLight&, const WorldBox&);

}  // namespace gluray::saved
