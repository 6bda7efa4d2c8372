// The lights that the setting `lights` puts in place of the program's. Made once a frame; any thread.
#pragma once
#include "render/camera/ray_setup.h"
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
  /// Azimuth and elevation of a direction: the inverse.
  glm::dvec2 anglesOf(const glm::dvec3& direction) const;
};

/// As the viewer sees them: right and up in the window, front towards the viewer. Also where eye space is
/// turned against the view, as in programs that give one matrix for all.
Directions cameraDirections(const RaySetup& eyeRays, const glm::ivec4& viewport);

/// Directions of the scene with this axis upwards (0: x).
Directions sceneDirections(const glm::dmat4& eyeFromWorld, int upAxis);

/// Those that the rig of the settings is directed by.
Directions rigDirections(const Settings&, const glm::dmat4& eyeFromWorld, const Directions& camera);

struct Rig {
  std::vector<scene::LightSource> lights;
  float headlight = 0;  // strength of the light at the viewer; 0: there is none
  scene::Dome dome;
};

/// Nothing for the program's own lights. The brightest white surface of a scene that is seen from its front
/// shows settings.lights.strength.
std::optional<Rig> makeRig(const Settings&, const glm::dmat4& eyeFromWorld, const Directions& camera = {});

}  // namespace gluray::render
