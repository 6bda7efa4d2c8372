// Queue of a tile's points whose rays are not traced yet. Used by one thread, while it traces the tile.
#pragma once
#include "render/integrators/surface_points.h"
#include "render/moving/channels.h"

namespace gluray::render {

/// Points with their history. Points of several packets of pixels share a packet of rays, so that the packet
/// is full although few pixels of each block trace rays.
struct WaitingPoints {
  AskedPoints asked;
  alignas(64) uint32_t pixel[kLanes];  // of the buffer
  alignas(64) Row samples;
  alignas(64) Row visibility[Channels::kMax];
  int count = 0;  // number of points, in the first lanes
};

}  // namespace gluray::render
