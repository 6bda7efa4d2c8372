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
  bool dome = false;           // light from all sides; the source's colour is the sky's
  bool followsViewer = false;  // a light of a program at the viewer
  scene::LightSource source;   // in the axes that the viewer sees: x right, y up, z towards the viewer
  std::optional<glm::dvec2>
      angles;  // azimuth and elevation by the axes of the rig, where there is a direction
};

/// Those that shine on the first lit surfaces of the view's snapshots: the program's, or in their place the
/// rig's, and those of lights.file. Throws std::runtime_error where a matrix cannot be inverted.
std::vector<ListedLight> listLights(const scene::Snapshot&);

/// Values of lights.azimuth and lights.elevation with which the key light's highlight is at a point. `normal`
/// is of unit length; both in eye space.
glm::dvec2 anglesOfHighlight(const scene::Snapshot&, const glm::dvec3& point, const glm::dvec3& normal);

}  // namespace gluray::frame
