// Rays of a packet against the triangles of a block, for the processor at hand. Private to accel/; called
// on tracing threads.
#pragma once
#include "accel/ray_packet.h"

#include <cstddef>
#include <cstdint>

namespace gluray::accel {

/// Rows of Embree's packet: `count` values each. Those from normalX on are null where hits are not written.
struct PacketRows {
  unsigned count;
  const int* valid;  // -1: the ray is asked about
  const float *orgX, *orgY, *orgZ, *tNear, *dirX, *dirY, *dirZ;
  float *tFar, *normalX, *normalY, *normalZ, *u, *v;
  uint32_t *primitive, *geometry, *instance;
};

/// What is written with each hit.
struct HitNames {
  uint32_t geometry, instance;
};

/// Triangles [first, end) of a mesh. `indices` null: a soup.
struct TriangleRun {
  const std::byte* positions;
  size_t stride;  // bytes
  const uint32_t* indices;
  uint32_t first, end;
};

/// Rays of a packet that have met a triangle, as many rows as a vector has lanes, from ray `first` on.
struct MetTriangle {
  uint32_t triangle;
  unsigned first;
  uint32_t rays;  // bit i: ray first + i
  float t[kLanes], u[kLanes], v[kLanes];
};
/// Decides which rays of it take the hit; their tFar it has set.
using Chooser = uint32_t (*)(const void* query, const PacketRows&, const MetTriangle&);

/// Writes the nearest hits into the packet. Without a chooser every hit counts.
void meetTriangles(const TriangleRun&, const PacketRows&, const HitNames&, Chooser, const void* query);

/// Sets tFar of the rays that any of the triangles blocks to minus infinity, as Embree marks occluded rays. The
/// chooser then need not set it. Without a chooser every triangle blocks.
void occludeTriangles(const TriangleRun&, const PacketRows&, Chooser, const void* query);

}  // namespace gluray::accel
