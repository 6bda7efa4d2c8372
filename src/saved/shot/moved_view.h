// Batches as cameras in other places see them. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <limits>
#include <vector>

namespace gluray::saved {

/// A box in eye space; empty at first.
struct Box {
  glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
  void add(const glm::dvec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  bool empty() const { return !(low.x <= high.x); }
  glm::dvec3 middle() const { return (low + high) / 2.0; }
  double radius() const { return glm::length(high - low) / 2; }
};

/// Whether both have the same camera and viewport. `eyeFromEye`: from the eye space of the other to its own.
bool sharesView(const scene::Snapshot& own, const scene::Snapshot& other, glm::dmat4& eyeFromEye);

/// The box around the surfaces of all batches of its view, in its eye space moved by `by`.
Box boxOfView(const scene::Snapshot& own, const std::vector<scene::SnapshotPtr>& batches,
              const glm::dmat4& by = glm::dmat4(1));

/// What becomes of the near and far planes.
enum class Planes {
  roomy,  // they stay, unless they cut surfaces off
  tight   // they enclose the surfaces, as far as one can see in both directions
};

/// How much larger things are in the window.
struct Zoom {
  double factor = 1;
  glm::dvec3 ahead{0, 0, -1};  // eye space: a point before the viewer, on the line of sight
};

/// The batch with its surfaces moved in its eye space. Lights stay at the camera. `box`: of the view's
/// surfaces where they are then. What the real OpenGL drew is forgotten.
scene::SnapshotPtr moved(const scene::Snapshot& batch, const glm::dmat4& by, const Box& box, Planes planes,
                         const Zoom& zoom = {});

}  // namespace gluray::saved
