// The lights that the setting `lights` puts in place of the program's. Made once a frame; any thread.
#pragma once
#include "scene/light_source.h"
#include "settings/settings.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace gluray::render {

/// What lights are directed by, eye space: unit vectors, at right angles to each other.
struct Directions {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, front{0, 0, 1};
  /// Towards a light. Degrees: to the right of the front, above the horizon.
  glm::vec3 towards(double azimuth, double elevation) const;
};

/// Directions of the scene with this axis upwards (0: x).
Directions sceneDirections(const glm::dmat4& eyeFromWorld, int upAxis);

struct Rig {
  std::vector<scene::LightSource> lights;
  float headlight = 0;  // strength of the light at the viewer; 0: there is none
  scene::Dome dome;
};

/// Nothing for the program's own lights. The brightest white surface of a scene that is seen from its front
/// shows settings.lights.strength.
std::optional<Rig> makeRig(const Settings&, const glm::dmat4& eyeFromWorld);

}  // namespace gluray::render
