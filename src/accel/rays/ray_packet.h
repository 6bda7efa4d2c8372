// Packets of sixteen rays with their hits, as structures of arrays. render/ fills them, accel/ traces them.
// Any thread.
#pragma once
#include <cstdint>

namespace gluray::accel {

constexpr int kLanes = 16;                // rays in a packet
constexpr uint32_t kNoHit = 0xFFFFFFFFu;  // value of `geometry` where the ray hit nothing

/// Whether the rays of a packet have similar directions. Embree traces coherent packets as a whole, which
/// halves the speed for incoherent rays.
enum class Coherence : bool { coherent, incoherent };

/// A packet of rays org + t*dir, t in (tNear, tFar]. `dir` may have any length; t is in units of it.
/// The lanes are 4x4 pixels in Z order of 2x2 quads: lanes 0-3 are one quad, 0-7 a 4x2 block.
/// Same layout as Embree's packet: Embree reads and writes it in place.
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

/// The rays of a packet in eye space, which is more precise than world space for objects far from the world's
/// origin. t as in the packet.
struct alignas(64) PixelRays {
  float orgX[kLanes], orgY[kLanes], orgZ[kLanes], dirX[kLanes], dirY[kLanes], dirZ[kLanes];
  float tFar[kLanes];  // the end of the ray, hit or not
  float windowX[kLanes], windowY[kLanes];
};

/// Rays against impostors (scene/impostors.h): shader programs compute them at pixel centres, for the samples
/// that their billboards cover. Without centers and samples, rays hit impostors as solids
/// (impostors/solid.h), as do rays through a lens.
struct ImpostorQuery {
  const PixelRays* centers = nullptr;  // through the centres of the rays' pixels
  const PixelRays* samples = nullptr;  // the packet's rays
};

}  // namespace gluray::accel
