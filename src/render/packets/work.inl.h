// A packet of rays on its way to pixels. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_WORK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_WORK_INL_H_
#undef GLURAY_RENDER_WORK_INL_H_
#else
#define GLURAY_RENDER_WORK_INL_H_
#endif

#include "render/hit_points/impostor.inl.h"
#include "render/hit_points/lens_hits.inl.h"
#include "render/integrators/light_visibility.h"
#include "render/packets/drawn_fragments.h"
#include "render/packets/peeled_layers.h"
#include "render/shading/shade.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// How much of each lane's pixel layers cover so far.
struct Cover {
  const float* opacity =
      nullptr;  // of all of them; null: hits take all light samples, whatever their opacity
  // Of those in front of the depth `place`: hits at that depth are in front of none there, so that both hits
  // on an edge that two triangles share have the same light. Null: depths do not matter.
  const float* before = nullptr;
  const float* place = nullptr;
  float tolerance = 0;  // of equal depths

  float at(int lane, float depth) const {
    const bool same = before && std::abs(depth - place[lane]) <= tolerance;
    return same ? before[lane] : opacity[lane];
  }
};

/// State of a packet from ray generation to pixels.
struct Work {
  accel::RayPacket packet;
  accel::PixelRays centers, samples;  // only if there are impostors
  accel::ImpostorQuery impostors;
  alignas(64) float x[kLanes], y[kLanes];  // window positions
  alignas(64) int32_t valid[kLanes];       // -1: trace this lane
  alignas(64) uint32_t vertex[3][kLanes];  // of the hit triangles
  alignas(64) uint32_t color[kLanes];      // RGBA8, or
  alignas(64) Row wide[4];                 // float colours, if the image has these
  alignas(64) float through[kLanes];
  alignas(64) float depth[kLanes];
  alignas(64) float edgeDepth[kLanes];
  DrawnFragments fragments;    // only for layers blended in the order of drawing
  PeeledLayers peeled;         // only for layers with a limited number of peels
  uint32_t hits = 0;           // bit i: lane i hit something
  uint32_t edged = 0;          // bit i: lane i hit a triangle grown by its edges; its depth is edgeDepth
  int imageX = 0, imageY = 0;  // pixel of lane 0
  int sample = 0;
  bool colors = true;  // hits get colours now; false: only if these decide whether they are there
  bool lights = true;  // hits are given to the integrator, or to the collector
  const Visibility* visibility = nullptr;  // where it is known
  WaitingPoints* waiting = nullptr;        // where points wait for rays, if visibility is collected
  Cover cover;                             // of layers
  const Lens* lens = nullptr;              // null: the rays leave the viewpoint
  LensPoints lensPoints;
  /// Rays of neighbouring pixels leave different points of a lens.
  accel::Coherence coherence() const {
    return lens ? accel::Coherence::incoherent : accel::Coherence::coherent;
  }
};

/// Averages know hits on a catcher by their depth: below 0, in place of `depth`.
constexpr float caughtAt(float depth) { return -1 - depth; }
constexpr bool isCaught(float depth) { return depth < 0; }
constexpr float depthOfCaught(float depth) { return -1 - depth; }
/// The one of two depths that the depth test prefers; Image::kMiss is no depth.
constexpr float firstDepth(const scene::Camera& camera, float a, float b) {
  if (a == Image::kMiss || b == Image::kMiss) return std::min(a, b);
  return camera.largestWins ? std::max(a, b) : std::min(a, b);
}

// Pixel of lane i within its 4x4 block: Z order of 2x2 quads.
constexpr int laneX(int i) { return (i & 1) + (i >> 1 & 2); }
constexpr int laneY(int i) { return (i >> 1 & 1) + (i >> 2 & 2); }

struct LaneOffsets {
  alignas(64) float x[kLanes], y[kLanes];
  constexpr LaneOffsets() : x(), y() {
    for (int i = 0; i < kLanes; ++i) x[i] = static_cast<float>(laneX(i)), y[i] = static_cast<float>(laneY(i));
  }
};
inline constexpr LaneOffsets kLaneOffsets;

using IndexTag = hn::Rebind<uint32_t, FloatTag>;

// The mask of the vector that begins at lane i, from bits.
HWY_INLINE hn::Mask<IndexTag> maskAt(uint32_t lanes, int i) {
  return hn::RebindMask(IndexTag(), lanesAt(lanes, i));
}
HWY_INLINE uint32_t bitsAt(hn::Mask<IndexTag> mask, int i) {
  uint8_t bits[8] = {};
  hn::StoreMaskBits(IndexTag(), mask, bits);
  return (bits[0] | static_cast<uint32_t>(bits[1]) << 8) << i;
}

/// Window positions of the centres of a packet's pixels.
struct Centers {
  alignas(64) float x[kLanes], y[kLanes];
};

HWY_ATTR inline uint32_t lanesThatHit(const accel::RayPacket& packet, const int32_t* valid) {
  const IndexTag d;
  const hn::Rebind<int32_t, FloatTag> di;
  uint32_t lanes = 0;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto traced = hn::BitCast(d, hn::Load(di, valid + i));
    const auto missed = hn::Eq(hn::Load(d, packet.geometry + i), hn::Set(d, accel::kNoHit));
    lanes |= bitsAt(hn::And(hn::Ne(traced, hn::Zero(d)), hn::Not(missed)), i);
  }
  return lanes;
}

// The lanes among `lanes` that hit the same instance as the first of them.
HWY_ATTR inline void gather(const Work& work, uint32_t lanes, Group& group) {
  const IndexTag d;
  const accel::RayPacket& packet = work.packet;
  const int leader = std::countr_zero(lanes);
  group.lanes = 0;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto same = hn::Eq(hn::Load(d, packet.instance + i), hn::Set(d, packet.instance[leader]));
    const auto member = hn::And(same, maskAt(lanes, i));
    group.lanes |= bitsAt(member, i);
    const auto take = [&](const uint32_t* from, uint32_t* to) HWY_ATTR {
      hn::Store(hn::IfThenElse(member, hn::Load(d, from + i), hn::Set(d, from[leader])), d, to + i);
    };
    take(packet.primitive, group.primitive);
    for (int k = 0; k < 3; ++k) take(work.vertex[k], group.vertex[k]);
    const auto memberF = hn::RebindMask(FloatTag(), member);
    store(hn::IfThenElse(memberF, load(packet.u + i), splat(packet.u[leader])), group.u + i);
    store(hn::IfThenElse(memberF, load(packet.v + i), splat(packet.v[leader])), group.v + i);
  }
}

// Copies `lanes` of `from`.
HWY_ATTR inline void blendRow(uint32_t lanes, const float* from, float* to) {
  for (int i = 0; i < kLanes; i += lanesOfVector())
    store(hn::IfThenElse(lanesAt(lanes, i), load(from + i), load(to + i)), to + i);
}

// Writes colour and depth of `lanes` into the pixels.
HWY_ATTR inline void merge(uint32_t lanes, const LitRows& rows, const float* depth, bool wide, Work& work) {
  blendRow(lanes, depth, work.depth);
  if (wide) {
    for (int c = 0; c < 4; ++c) blendRow(lanes, rows.value[c], work.wide[c]);
    return;
  }
  const IndexTag d;
  alignas(64) uint32_t color[kLanes];
  packColors(rows, color);
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto member = maskAt(lanes, i);
    hn::Store(hn::IfThenElse(member, hn::Load(d, color + i), hn::Load(d, work.color + i)), d, work.color + i);
  }
}

// Writes the depths of `lanes` alone.
HWY_ATTR inline void mergeDepths(uint32_t lanes, const float* depth, Work& work) {
  blendRow(lanes & ~work.edged, depth, work.depth);
  if (lanes & work.edged) blendRow(lanes & work.edged, work.edgeDepth, work.depth);
}

// The same for hits of which some are on triangles grown by their edges.
HWY_ATTR inline void mergeShown(uint32_t lanes, const LitRows& rows, const float* depth, bool wide,
                                Work& work) {
  merge(lanes & ~work.edged, rows, depth, wide, work);
  if (lanes & work.edged) merge(lanes & work.edged, rows, work.edgeDepth, wide, work);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
