#include "render/remote/remote_surfaces.h"

#include "render/frame_data/frame_data.h"

namespace gluray::render {

namespace {

/// Dims what passes by the view's volumes. Rays that surfaces block keep what they have.
void passMedia(const FrameData& frame, const int32_t* valid, const accel::OcclusionRays& rays,
               uint32_t blocked, Passing passing) noexcept {
  for (int i = 0; i < kLanes; ++i) {
    if (!valid[i] || (blocked >> i & 1)) continue;
    const float through = transmittanceOf(frame.media, {rays.orgX[i], rays.orgY[i], rays.orgZ[i]},
                                          {rays.dirX[i], rays.dirY[i], rays.dirZ[i]}, rays.tFar[i]);
    if (passing.grey) passing.grey[i] *= through;
    if (passing.colored) passing.colored[i] *= through;
  }
}

uint32_t occludedBySurfaces(const FrameData& frame, const int32_t* valid, accel::OcclusionRays& rays,
                            accel::RayKind kind, const accel::OccluderFilter* filter, Passing passing,
                            const glm::vec3* lamp) noexcept {
  uint32_t blocked = 0;
  if (frame.remote && !filter && frame.remote->recall(blocked)) return blocked;
  blocked = frame.world->occluded(valid, rays, filter, kind);
  return frame.remote ? frame.remote->occluded({valid, rays, kind, lamp}, blocked, passing) : blocked;
}

}  // namespace

uint32_t occludedAnywhere(const FrameData& frame, const int32_t* valid, accel::OcclusionRays& rays,
                          accel::RayKind kind, const accel::OccluderFilter* filter, Passing passing,
                          const glm::vec3* lamp) noexcept {
  const uint32_t blocked = occludedBySurfaces(frame, valid, rays, kind, filter, passing, lamp);
  if (!frame.media.empty()) passMedia(frame, valid, rays, blocked, passing);
  return blocked;
}

uint32_t occludedHere(const FrameData& frame, const int32_t* valid, accel::OcclusionRays& rays,
                      accel::RayKind kind, const accel::OccluderFilter* filter, Passing passing) noexcept {
  const uint32_t blocked = frame.world->occluded(valid, rays, filter, kind);
  if (!frame.media.empty()) passMedia(frame, valid, rays, blocked, passing);
  return blocked;
}

}  // namespace gluray::render
