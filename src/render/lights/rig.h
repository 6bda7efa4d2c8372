// Light rigs of the setting `lights`, which replace the program's lights. Made once a frame; any thread.
#pragma once
#include "render/camera/ray_setup.h"
#include "scene/light_source.h"
#include "settings/settings.h"

#include <glm/glm.hpp>

#include <optional>
#include <vector>

namespace gluray::render {

/// The frame of reference of a light rig: orthogonal unit vectors right, up and front in eye space.
struct Directions {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, front{0, 0, 1};
  /// Direction towards a light. `azimuth`: degrees to the right of the front; `elevation`: degrees above the
  /// horizon.
  glm::vec3 towards(double azimuth, double elevation) const;
  /// Azimuth and elevation of a direction in degrees: the inverse of towards().
  glm::dvec2 anglesOf(const glm::dvec3& direction) const;
};

/// The camera's frame: right and up in the window, front towards the viewer. Holds also if eye space is
/// rotated against the view, as in programs that give only the product of all matrices.
Directions cameraDirections(const RaySetup& eyeRays, const glm::ivec4& viewport);

/// The scene's frame with this upward axis (0: x).
Directions sceneDirections(const glm::dmat4& eyeFromWorld, int upAxis);

/// The frame of the rig in the settings.
Directions rigDirections(const Settings&, const glm::dmat4& eyeFromWorld, const Directions& camera);

struct Rig {
  std::vector<scene::LightSource> lights;
  float headlight = 0;  // strength of the light at the viewer; 0: none
  float program = 0;    // factor of the program's lights; 0: the rig replaces them
  scene::Dome dome;
};

/// Makes the rig of the settings; none for the program's own lights. The brightest white surface of a scene
/// seen from the front has the value settings.lights.strength.
std::optional<Rig> makeRig(const Settings&, const glm::dmat4& eyeFromWorld, const Directions& camera = {});

}  // namespace gluray::render
