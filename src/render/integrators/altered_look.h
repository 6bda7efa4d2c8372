// The local look of other materials under other lights: what of it are the surfaces' own colours, and what
// they emit. Made once a frame, read by every tracing thread.
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

/// What light transport asks the local look for.
struct SurfaceColors {
  std::unique_ptr<const AlteredLook> albedo;    // diffuse colour times vertex colours and textures
  std::unique_ptr<const AlteredLook> emission;  // null: nothing emits. Not of surfaces without lighting
};

/// Of hits of the camera; with `edges`: with the edges that programs paint, which exist in the window only.
SurfaceColors surfaceColors(const FrameData&, bool edges);

/// Whether some program paints edges.
bool paintsEdges(const scene::Snapshot&);

}  // namespace gluray::render
