// The shadings of a frame whose lights the settings change. Made once a frame, read by every tracing thread.
#pragma once
#include "scene/light_source.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace gluray::render {

/// Shadings with other lights. Those that are not lit stay as they are.
struct Relit {
  std::vector<scene::Shading> shadings;
  std::vector<uint32_t> shadingOf;          // one for each of Snapshot::instances
  std::vector<scene::LightSource> sources;  // eye space
  std::vector<size_t> firstSource;          // of a shading: the index of its light that is source 0
  scene::Dome dome;                         // shines on all that is lit
};

/// Where the viewer is: at the point away.xyz / away.w, or infinitely far away.
using Viewer = glm::dvec4;

/// Null where the snapshot's settings leave the program its lights.
std::shared_ptr<const Relit> relight(const scene::Snapshot&, const Viewer& away);

/// Maps a program's lighting space to eye space; exactly the identity where they are the same up to the
/// rounding of float matrices.
glm::dmat4 eyeFromLighting(const scene::Instance&);

/// Whether two such matrices are the same up to that rounding. `reach`: how far from the viewer things are.
bool isNearly(const glm::dmat4& a, const glm::dmat4& b, double reach);

}  // namespace gluray::render
