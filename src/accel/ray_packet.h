// Sixteen rays and what they hit, as structure of arrays: what render/ hands to accel/ and gets back. Any
// thread.
#pragma once
#include <cstdint>

namespace gluray::accel {

constexpr int kLanes = 16;                // rays in a packet
constexpr uint32_t kNoHit = 0xFFFFFFFFu;  // in `geometry` of a ray that hit nothing

/// A packet of rays org + t*dir, t in (tNear, tFar]. Lengths of `dir` are free; t is in units of it.
/// The lanes are 4x4 pixels in Z order of 2x2 quads: lanes 0-3 are one quad, 0-7 a 4x2 block.
/// The layout is that of Embree's packet, which is read and written in place.
struct alignas(64) RayPacket {
  float orgX[kLanes], orgY[kLanes], orgZ[kLanes], tNear[kLanes];
  float dirX[kLanes], dirY[kLanes], dirZ[kLanes], time[kLanes];
  float tFar[kLanes];  // after the query: the hit's t
  uint32_t mask[kLanes], id[kLanes], flags[kLanes];
  float normalX[kLanes], normalY[kLanes],
      normalZ[kLanes];         // of the hit triangle, object space, not of unit length
  float u[kLanes], v[kLanes];  // barycentric: hit = (1-u-v)*corner0 + u*corner1 + v*corner2
  uint32_t primitive[kLanes];  // triangle of the mesh
  uint32_t geometry[kLanes];   // kNoHit: the ray hit nothing
  uint32_t instance[kLanes];   // index into Snapshot::instances
  uint32_t reserved[kLanes];   // later Embree versions write here
};

/// Rays of a packet in eye space, where nothing is as far from the origin as objects may be in the world. t
/// counts as in the packet.
struct alignas(64) PixelRays {
  float orgX[kLanes], orgY[kLanes], orgZ[kLanes], dirX[kLanes], dirY[kLanes], dirZ[kLanes];
  float tFar[kLanes];  // the end of the ray, whatever was hit
  float windowX[kLanes], windowY[kLanes];
};

/// What impostors (scene/impostors.h) are met by: programs compute them for the centres of pixels, on those
/// samples that their billboards cover.
struct ImpostorQuery {
  const PixelRays* centers = nullptr;  // of the pixels that the packet's rays belong to
  const PixelRays* samples = nullptr;  // the packet's rays
};

}  // namespace gluray::accel
