// The camera of a saved view, for those who know nothing of the program's cameras. Any thread.
#pragma once
#include "saved/shot/path_view.h"
#include "saved/shot/view_camera.h"
#include "scene/snapshot.h"

#include <optional>
#include <vector>

namespace gluray::saved {

/// A camera that knownView() finds to be that of the saved view.
struct DerivedCamera {
  ViewCamera camera;
  KnownView known;
  // A ball around the view's surfaces, in the camera's world.
  glm::dvec3 middle{0};
  double radius = 1;
};

/// The camera of the largest view, in the object space of its first surface that is neither stretched nor
/// sheared, or in a space with the axes of a surface and the lengths of the camera's own space. Its focal
/// point lies on the line of sight, as deep as the middle of the surfaces. None: no surface has such a space.
std::optional<DerivedCamera> derivedCamera(const std::vector<scene::SnapshotPtr>& batches);

/// A space in which a batch's camera sees lengths and angles as they are: to eye space. It is eye space
/// itself, or, where programs stretch that along its axes, as VTK stretches the coordinates of buffers, the
/// space of a surface's lighting. None: neither is such a space.
std::optional<glm::dmat4> eyeFromEven(const scene::Snapshot& batch);

}  // namespace gluray::saved
