#include "render/remote/remote_surfaces.h"

#include "render/frame_data/frame_data.h"

namespace gluray::render {

uint32_t occludedAnywhere(const FrameData& frame, const int32_t* valid, accel::OcclusionRays& rays,
                          accel::RayKind kind, const accel::OccluderFilter* filter, Passing passing,
                          const glm::vec3* lamp) noexcept {
  uint32_t blocked = 0;
  if (frame.remote && !filter && frame.remote->recall(blocked)) return blocked;
  blocked = frame.world->occluded(valid, rays, filter, kind);
  return frame.remote ? frame.remote->occluded({valid, rays, kind, lamp}, blocked, passing) : blocked;
}

}  // namespace gluray::render
