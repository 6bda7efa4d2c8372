// The views that a frame's batches show. Any thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <vector>

namespace gluray::saved {

/// A batch, and the matrix from its eye space to that of its view's first batch.
struct ViewBatch {
  const scene::Snapshot* snapshot;
  glm::dmat4 viewFromEye{1};
};
using ViewBatches = std::vector<ViewBatch>;

/// Batches of one camera in one part of one framebuffer, in the order of drawing; layers that a program draws
/// into another framebuffer belong to the last view with their camera and size. The view with most pixels
/// comes first. Null pointers are left out.
std::vector<ViewBatches> sceneViewsOf(const std::vector<scene::SnapshotPtr>& batches);

/// The near plane of a projection, eye space.
struct NearPlane {
  glm::dvec3 middle, right, up;  // right and up: its edges
  glm::dvec3 away;               // of the line of sight through its middle
  explicit NearPlane(const scene::Camera&);
  /// Whether the window is a mirror image of eye space.
  bool isMirrored() const { return glm::dot(glm::cross(right, up), away) > 0; }
};

/// The matrix from a view's world to the eye space of its first batch: that of the batch or, where it does
/// not keep angles or the window is its mirror image, the nearest one for which that is not so: a camera can
/// stand in this world. Both move with the program's camera alike.
glm::dmat4 eyeFromWorldOf(const scene::Snapshot& first);

}  // namespace gluray::saved
