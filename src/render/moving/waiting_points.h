// Points of a tile that wait for their rays. Used by one thread, while it traces the tile.
#pragma once
#include "render/integrators/surface_points.h"
#include "render/moving/channels.h"

namespace gluray::render {

/// Points that take samples, with what is known of them. Those of several packets of pixels fill one packet
/// of rays, so that it is full although few pixels of each block trace.
struct WaitingPoints {
  AskedPoints asked;
  alignas(64) uint32_t pixel[kLanes];  // of the film
  alignas(64) Row samples;
  alignas(64) Row factors[Channels::kMax];
  int count = 0;  // points that wait, in the first lanes
};

}  // namespace gluray::render
