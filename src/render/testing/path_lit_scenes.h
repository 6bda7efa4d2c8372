// Scenes lit by a file of lights alone, for tests.
#pragma once
#include "render/testing/path_scenes.h"
#include "render/testing/test_light_file.h"

#include <vector>

namespace gluray::test {

/// The wall near the origin, or other meshes, lit by the file alone.
inline scene::Snapshot litBy(const LightFile& file, const std::vector<scene::MeshPtr>& meshes = {backWall()},
                             double degrees = 0.5) {
  scene::Snapshot s = pathView(meshes);
  s.camera.clipFromEye = glm::perspective(glm::radians(degrees), 1.0, 0.1, 1000.0);
  s.settings.environment.strength = 0;
  s.settings.lights.file = file.name;
  s.settings.path.depth = 1, s.settings.path.samples = 64;
  s.settings.shadows.size = 0;
  s.shadings[0].normalize = true;
  return s;
}

}  // namespace gluray::test
