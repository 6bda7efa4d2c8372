// Occlusion rays: the packet, and the filter of surfaces. render/ fills a packet and passes it to
// World::occluded; any thread.
#pragma once
#include "accel/rays/ray_packet.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace gluray::accel {

/// A packet of rays org + t*dir, t in [tNear, tFar], world space. `dir` may have any length; t is in units of
/// it. The layout is that of Embree's packet, which is read and written in place.
struct alignas(64) OcclusionRays {
  float orgX[kLanes], orgY[kLanes], orgZ[kLanes], tNear[kLanes];
  float dirX[kLanes], dirY[kLanes], dirZ[kLanes], time[kLanes];
  float tFar[kLanes];  // after the query: minus infinity where the ray is blocked
  uint32_t mask[kLanes], id[kLanes], flags[kLanes];
};

/// A surface that a ray hits.
struct Occluder {
  uint32_t instance, primitive;
  float u, v;       // of triangles: barycentric, as in RayPacket
  glm::vec3 point;  // object space
  int lane;         // of the ray
};

/// Decides which surfaces block rays. Called on tracing threads, for each ray in no particular order and at
/// most once for each primitive.
class OccluderFilter {
 public:
  virtual ~OccluderFilter() = default;
  /// Returns false if the ray continues through the surface.
  virtual bool blocks(const Occluder&) const noexcept = 0;
  /// Whether blocks() uses Occluder::point. If not, the points of impostors need not be computed, and are
  /// undefined.
  virtual bool usesPoints() const noexcept { return true; }
};

}  // namespace gluray::accel
