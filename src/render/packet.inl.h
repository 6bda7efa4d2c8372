// A packet from rays to pixels, and the tile loop. Part of kernels.cpp (compiled once for each instruction
// set).
#if defined(GLURAY_RENDER_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_PACKET_INL_H_
#undef GLURAY_RENDER_PACKET_INL_H_
#else
#define GLURAY_RENDER_PACKET_INL_H_
#endif

#include "render/depth.inl.h"
#include "render/shade.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The pixels of a packet: window positions in, colour and depth out.
struct Pixels {
  alignas(64) float x[kLanes], y[kLanes];
  alignas(64) int32_t valid[kLanes];  // -1: to be traced
  alignas(64) uint32_t color[kLanes];
  alignas(64) float depth[kLanes];
};

// Pixel of lane i within its 4x4 block: Z order of 2x2 quads.
constexpr int laneX(int i) { return (i & 1) + (i >> 1 & 2); }
constexpr int laneY(int i) { return (i >> 1 & 1) + (i >> 2 & 2); }

/// Culling and the clip planes of single instances, asked of every hit.
class RejectingFilter : public accel::HitFilter {
 public:
  explicit RejectingFilter(const FrameData& frame) : frame_(frame) {}
  bool accepts(uint32_t instance, uint32_t primitive, float u, float v, int) const noexcept override {
    return frame_.surfaces[instance].accepts(primitive, u, v);
  }

 private:
  const FrameData& frame_;
};

HWY_ATTR inline uint32_t lanesThatHit(const accel::RayPacket& packet, const int32_t* valid) {
  uint32_t lanes = 0;
  for (int i = 0; i < kLanes; ++i) {
    lanes |= static_cast<uint32_t>(valid[i] != 0 && packet.geometry[i] != accel::kNoHit) << i;
  }
  return lanes;
}

// The lanes among `lanes` that hit the same instance as the first of them.
HWY_ATTR inline void gather(const accel::RayPacket& packet, uint32_t lanes, Group& group) {
  const int leader = std::countr_zero(lanes);
  group.lanes = 0;
  for (int i = 0; i < kLanes; ++i) {
    const bool member = (lanes >> i & 1) && packet.instance[i] == packet.instance[leader];
    group.lanes |= static_cast<uint32_t>(member) << i;
    group.primitive[i] = packet.primitive[member ? i : leader];
    group.u[i] = packet.u[member ? i : leader];
    group.v[i] = packet.v[member ? i : leader];
  }
}

// Lanes whose hit is culled or cut away by the instance's own clip planes.
HWY_ATTR inline uint32_t rejectedLanes(const Surface& s, const Group& group, uint32_t ccw) {
  uint32_t rejected = ((s.cullsCcw ? ccw : 0) | (s.cullsCw ? ~ccw : 0)) & group.lanes;
  if (!s.ownClipPlanes) return rejected;
  for (uint32_t lanes = group.lanes & ~rejected; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (!s.accepts(group.primitive[i], group.u[i], group.v[i])) rejected |= 1u << i;
  }
  return rejected;
}

/// Depth and colour of the packet's hits in `lanes`. Returns the lanes whose hit does not count; only where
/// `mayReject`.
HWY_ATTR inline uint32_t shadeHits(const FrameData& frame, const accel::RayPacket& packet, uint32_t lanes,
                                   bool mayReject, Pixels& pixels) {
  uint32_t rejected = 0;
  Group group;
  DepthAndFacing seen;
  alignas(64) uint32_t color[kLanes];
  while (lanes) {
    gather(packet, lanes, group);
    lanes &= ~group.lanes;
    const Surface& surface = frame.surfaces[packet.instance[std::countr_zero(group.lanes)]];
    loadCorners(*surface.mesh, group);
    computeDepth(surface, frame.depth, group, pixels.x, pixels.y, seen);
    if (mayReject) {
      const uint32_t now = rejectedLanes(surface, group, seen.ccw);
      rejected |= now;
      group.lanes &= ~now;
      if (group.lanes == 0) continue;
    }
    const uint32_t back = (surface.frontIsCcw ? ~seen.ccw : seen.ccw) & group.lanes;
    shade(frame, surface, group, back, pixels.x, pixels.y, color);
    for (int i = 0; i < kLanes; ++i) {
      const bool member = group.lanes >> i & 1;
      pixels.color[i] = member ? color[i] : pixels.color[i];
      pixels.depth[i] = member ? seen.depth[i] : pixels.depth[i];
    }
  }
  return rejected;
}

// Traces again the lanes whose nearest hit does not count, this time asking about every hit on the way.
HWY_ATTR inline void traceThrough(const FrameData& frame, uint32_t lanes, accel::RayPacket& packet,
                                  Pixels& pixels) {
  for (int i = 0; i < kLanes; ++i) pixels.valid[i] = lanes >> i & 1 ? -1 : 0;
  generateRays(frame.rays, pixels.x, pixels.y, packet, pixels.valid);
  frame.world->intersect(pixels.valid, packet, RejectingFilter(frame));
  shadeHits(frame, packet, lanesThatHit(packet, pixels.valid), false, pixels);
}

/// Colour and depth of the valid pixels; others get a miss.
HWY_ATTR inline void tracePacket(const FrameData& frame, Pixels& pixels) {
  accel::RayPacket packet;
  for (int i = 0; i < kLanes; ++i) {
    pixels.color[i] = 0;
    pixels.depth[i] = Image::kMiss;
  }
  generateRays(frame.rays, pixels.x, pixels.y, packet, pixels.valid);
  frame.world->intersect(pixels.valid, packet);
  const uint32_t hits = lanesThatHit(packet, pixels.valid);
  if (hits == 0) return;
  const uint32_t rejected = shadeHits(frame, packet, hits, true, pixels);
  if (rejected) traceThrough(frame, rejected, packet, pixels);
}

HWY_ATTR inline void storePixels(const Pixels& pixels, const Tile& tile, int x, int y, int sample,
                                 Image& image) {
  const size_t plane =
      static_cast<size_t>(image.width) * static_cast<size_t>(image.height) * static_cast<size_t>(sample);
  for (int i = 0; i < kLanes; ++i) {
    const int px = x + laneX(i), py = y + laneY(i);
    if (px >= tile.x1 || py >= tile.y1) continue;
    const size_t at =
        plane + static_cast<size_t>(py) * static_cast<size_t>(image.width) + static_cast<size_t>(px);
    image.color[at] = pixels.color[i];
    image.depth[at] = pixels.depth[i];
  }
}

HWY_ATTR void traceTile(const FrameData& frame, const Tile& tile) {
  const scene::Region& region = frame.snapshot->region;
  Pixels pixels;
  for (size_t sample = 0; sample < frame.samplePositions.size(); ++sample) {
    const glm::dvec2 offset = glm::dvec2(region.x, region.y) + frame.samplePositions[sample];
    for (int y = tile.y0; y < tile.y1; y += 4) {
      for (int x = tile.x0; x < tile.x1; x += 4) {
        for (int i = 0; i < kLanes; ++i) {
          const int px = x + laneX(i), py = y + laneY(i);
          pixels.x[i] = static_cast<float>(px + offset.x);
          pixels.y[i] = static_cast<float>(py + offset.y);
          pixels.valid[i] = px < tile.x1 && py < tile.y1 ? -1 : 0;
        }
        tracePacket(frame, pixels);
        storePixels(pixels, tile, x, y, static_cast<int>(sample), *frame.image);
      }
    }
  }
}

const char* targetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
