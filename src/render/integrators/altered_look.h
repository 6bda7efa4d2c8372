// The local look with altered materials and lights, which yields the albedo and the emission of surfaces.
// Made once a frame, read by every tracing thread.
#pragma once
#include "render/frame_data/frame_data.h"

#include <memory>
#include <vector>

namespace gluray::render {

/// Copies of a frame's surfaces for the kernels' shade().
class AlteredLook {
 public:
  using AlterShading = void (*)(scene::Shading&);
  using AlterMaterials = void (*)(const scene::Shading& before, scene::MaterialPair&);

  /// `frame` must outlive it.
  AlteredLook(const FrameData& frame, AlterShading, AlterMaterials);
  const Surface& operator[](uint32_t instance) const { return surfaces_[instance]; }

 private:
  std::vector<scene::Shading> shadings_;
  std::vector<Lighting> lightings_;  // of these
  std::vector<std::vector<scene::MaterialPair>> materials_;
  std::vector<Surface> surfaces_;  // as FrameData::surfaces
};

/// Albedo and emission of surfaces, for light transport.
struct SurfaceColors {
  std::unique_ptr<const AlteredLook> albedo;    // diffuse colour times vertex colours and textures
  std::unique_ptr<const AlteredLook> emission;  // null: no emission. Excludes surfaces without lighting
};

/// Makes the colours. `edges`: include painted edges, which exist only for camera rays.
SurfaceColors surfaceColors(const FrameData&, bool edges);

/// Whether some surface has painted edges.
bool paintsEdges(const scene::Snapshot&);

}  // namespace gluray::render
