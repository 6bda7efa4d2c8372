// The nearest hits of a frame's pixels, stored until their visibility is filtered. One thread at a
// time writes or reads the packets of a tile.
#pragma once
#include "accel/rays/ray_packet.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::render {

using accel::kLanes;

/// The hits of one packet, as in accel::RayPacket.
struct alignas(64) PacketHits {
  uint32_t instance[kLanes], primitive[kLanes];
  float u[kLanes], v[kLanes];
};

struct HitBuffer {
  /// Valid lanes of a packet; other hits are undefined.
  struct Lanes {
    uint16_t shown = 0;   // bit i: lane i shows a hit
    uint16_t edged = 0;   // bit i: on a triangle grown by its edges, with its own depth
    uint16_t hidden = 0;  // bit i: surfaces of another process hide the hit (render/remote)
  };

  int columns = 0;  // packets in a row
  std::vector<Lanes> lanes;
  std::vector<PacketHits> hits;
  std::vector<float> edgeDepth;  // one row of lanes for each packet, where triangles grow by their edges

  /// Throws std::bad_alloc.
  void resize(int width, int height, bool edges) {
    columns = (width + 3) / 4;
    const size_t packets = static_cast<size_t>(columns) * static_cast<size_t>((height + 3) / 4);
    lanes.resize(packets), hits.resize(packets), edgeDepth.resize(edges ? packets * kLanes : 0);
  }
  /// Index of the packet whose lower left pixel is (x, y).
  size_t at(int x, int y) const {
    return static_cast<size_t>(y / 4) * static_cast<size_t>(columns) + static_cast<size_t>(x / 4);
  }
  size_t bytes() const {
    return lanes.capacity() * sizeof(Lanes) + hits.capacity() * sizeof(PacketHits) +
           edgeDepth.capacity() * sizeof(float);
  }
};

}  // namespace gluray::render
