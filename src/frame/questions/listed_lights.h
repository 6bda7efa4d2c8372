// The lights of a view, for users. Any thread.
#pragma once
#include "frame/questions/viewer.h"
#include "scene/light_source.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gluray::frame {

struct ListedLight {
  enum class From : uint8_t { program, rig, file };
  std::string name;  // "key", "program 1"
  From from = From::program;
  bool dome = false;                 // light from all sides; `source` has the sky's colour
  bool followsViewer = false;        // a program's headlight
  scene::LightSource source;         // in the camera's axes: x right, y up, z towards the viewer
  std::optional<glm::dvec2> angles;  // azimuth and elevation in the rig's axes, if it has a direction
};

/// Lists the lights of the first lit surfaces of the view's snapshots: the program's lights or the rig that
/// replaces them, and the lights of lights.file. Throws std::runtime_error if a matrix cannot be inverted.
std::vector<ListedLight> listLights(const scene::Snapshot&);

/// Returns lights.azimuth and lights.elevation for which the key light's highlight is at `point`. `normal`
/// has unit length; both in eye space.
glm::dvec2 anglesOfHighlight(const scene::Snapshot&, const glm::dvec3& point, const glm::dvec3& normal);

}  // namespace gluray::frame
