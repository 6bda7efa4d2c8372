// The shadings of a frame whose lights the settings change. Made once a frame, read by every tracing thread.
#pragma once
#include "render/camera/ray_setup.h"
#include "scene/light_source.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace gluray::render {

/// Shadings with other lights. Those that are not lit stay as they are.
struct Relit {
  std::vector<scene::Shading> shadings;
  std::vector<uint32_t> shadingOf;  // one for each of Snapshot::instances
  // In place of the snapshot's, if some do not say where their lighting space is; otherwise empty.
  std::vector<scene::Instance> instances;
  std::vector<scene::LightSource> sources;  // eye space
  // Of a shading: the index of its light that is source 0; the number of its lights if it has no sources.
  std::vector<size_t> firstSource;
  // Of the snapshot's surroundings, without sources; empty: these keep their lights.
  std::vector<scene::Shading> surroundings;
  scene::Dome dome;  // shines on all that is lit
};

/// Null where the snapshot's settings leave the program its lights. `eyeRays`: of the snapshot's camera.
std::shared_ptr<const Relit> relight(const scene::Snapshot&, const RaySetup& eyeRays);

}  // namespace gluray::render
