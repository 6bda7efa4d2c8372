// SIMD intersection of a packet's rays with the triangles of one triangle block, compiled for several
// instruction sets. Private to accel/; called on tracing threads.
#pragma once
#include "accel/rays/ray_packet.h"

#include <cstddef>
#include <cstdint>

namespace gluray::accel {

/// Pointers into Embree's ray packet: `count` values each. Those from normalX on are null if hits are not
/// written.
struct PacketRows {
  unsigned count;
  const int* valid;  // -1: the ray is active
  const float *orgX, *orgY, *orgZ, *tNear, *dirX, *dirY, *dirZ;
  float *tFar, *normalX, *normalY, *normalZ, *u, *v;
  uint32_t *primitive, *geometry, *instance;
};

/// The identifiers written with each hit.
struct HitNames {
  uint32_t geometry, instance;
};

/// A range of triangles, [first, end) of a mesh: a triangle block. `indices` null: triangle soup.
struct TriangleRun {
  const std::byte* positions;
  size_t stride;  // bytes
  const uint32_t* indices;
  uint32_t first, end;
};

/// The rays that hit a triangle, in one vector of consecutive rays that starts at ray `first`.
struct MetTriangle {
  uint32_t triangle;
  unsigned first;
  uint32_t rays;  // bit i: ray first + i
  float t[kLanes], u[kLanes], v[kLanes];
};
/// Returns the subset of MetTriangle::rays that accept the hit, after setting their tFar.
using Chooser = uint32_t (*)(const void* query, const PacketRows&, const MetTriangle&);

/// Writes the nearest hits into the packet. A null chooser accepts every hit.
void meetTriangles(const TriangleRun&, const PacketRows&, const HitNames&, Chooser, const void* query);

/// Sets tFar of the rays that any of the triangles blocks to minus infinity, as Embree marks occluded rays.
/// The chooser then need not set it. Without a chooser every triangle blocks.
void occludeTriangles(const TriangleRun&, const PacketRows&, Chooser, const void* query);

}  // namespace gluray::accel
