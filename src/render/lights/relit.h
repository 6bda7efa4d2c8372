// The shadings of a frame whose lights the settings change. Made once a frame, read by every tracing thread.
#pragma once
#include "render/camera/ray_setup.h"
#include "scene/light_source.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace gluray::render {

/// Shadings with replaced lights. Unlit shadings do not change.
struct Relit {
  std::vector<scene::Shading> shadings;
  std::vector<uint32_t> shadingOf;  // one for each of Snapshot::instances
  // Replacements of the snapshot's instances, if some have no known lighting space; otherwise empty.
  std::vector<scene::Instance> instances;
  std::vector<scene::LightSource> sources;  // eye space
  // For each shading: index of its light that is source 0; its number of lights if it has no sources.
  std::vector<size_t> firstSource;
  // Shadings of the snapshot's secondary scene, without sources; empty: its surfaces keep their lights.
  std::vector<scene::Shading> secondaryShadings;
  scene::Dome dome;  // shines on all lit surfaces
};

/// Null if the settings keep the program's lights. `eyeRays`: of the snapshot's camera.
std::shared_ptr<const Relit> relight(const scene::Snapshot&, const RaySetup& eyeRays);

}  // namespace gluray::render
