// The local look without ambient light, for integrators that darken only ambient light. Made once a frame,
// read by every tracing thread.
#pragma once
#include "render/frame_data/frame_data.h"

#include <memory>
#include <vector>

namespace gluray::render {

struct DirectLook {
  std::vector<scene::Shading> shadings;
  std::vector<Lighting> lightings;  // of these
  std::vector<std::vector<scene::MaterialPair>> materials;
  std::vector<Surface> surfaces;  // one for each of Snapshot::instances

  /// Copies of the frame's surfaces whose lights and materials have no ambient colours. `frame` must outlive
  /// it.
  explicit DirectLook(const FrameData& frame);
};

/// Null if the snapshot's settings do not need it.
std::unique_ptr<const DirectLook> makeDirectLook(const FrameData&);

}  // namespace gluray::render
