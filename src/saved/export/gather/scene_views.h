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

}  // namespace gluray::saved
