// Transparent layers (scene::Layers): all hits of a packet's rays, composited or summed. Part of kernels.cpp
// (compiled once for each instruction set).
#if defined(GLURAY_RENDER_LAYERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_LAYERS_INL_H_
#undef GLURAY_RENDER_LAYERS_INL_H_
#else
#define GLURAY_RENDER_LAYERS_INL_H_
#endif

#include "accel/rays/next_hits.h"
#include "render/layers/edge_hits.h"
#include "render/remote/remote_surfaces.h"
#include "render/visibility/edges.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Accumulated layers of a packet. Rows: premultiplied colours, and the total opacity.
struct Gathered {
  alignas(64) Row before[4] = {};  // without the fragments at the current depth
  alignas(64) Row now[4] = {};     // with them
  float place[kLanes];             // the current depth
  uint8_t places[kLanes] = {};     // number of different depths so far
};

/// Composites the fragments of `lanes` behind the layers so far. `colors`: otherwise rows are auxiliary
/// features, which are not limited to 0 .. 1.
HWY_ATTR inline void putBehind(uint32_t lanes, const LitRows& rows, const float* depth, float tolerance,
                               Gathered& g, bool colors = true) {
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (!(std::abs(depth[i] - g.place[i]) <= tolerance)) {
      for (int c = 0; c < 4; ++c) g.before[c][i] = g.now[c][i];
      g.place[i] = depth[i];
      if (g.places[i] + 1u < LayerCounts::kMax) ++g.places[i];
    }
    const float weight = (1 - g.before[3][i]) * rows.value[3][i];
    for (int c = 0; c < 4; ++c) {
      const float added = g.before[c][i] + weight * (c < 3 ? rows.value[c][i] : 1);
      const bool limited = colors || c == 3;
      g.now[c][i] = limited ? std::clamp(added, g.now[c][i], std::max(g.now[c][i], 1.0f)) : added;
    }
  }
}

/// A lane's pixel index in the image.
inline size_t pixelOf(const FrameData& frame, const Work& work, int lane) {
  return static_cast<size_t>(work.imageY + laneY(lane)) * static_cast<size_t>(frame.image->width) +
         static_cast<size_t>(work.imageX + laneX(lane));
}

/// The lanes whose fragment lies behind the opaque surface by more than `reach`.
HWY_ATTR inline uint32_t lanesBehind(const scene::Layers& layers, const FrameData& frame, const Work& work,
                                     uint32_t lanes, const float* depth, float reach = 0) {
  uint32_t behind = 0;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const float opaque = layers.opaqueDepth[pixelOf(frame, work, i)];
    if (opaque >= 0 && depth[i] > opaque + reach) behind |= 1u << i;
  }
  return behind;
}

/// The lanes whose layers are opaque.
HWY_ATTR inline uint32_t lanesFull(uint32_t lanes, const Gathered& g) {
  constexpr float kNothing = 0.5f / 255;  // less is invisible
  uint32_t full = 0;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (g.now[3][i] > 1 - kNothing) full |= 1u << i;
  }
  return full;
}

/// Copies each lane's i-th hit into the packet. Returns the lanes that have one.
HWY_ATTR inline uint32_t takeHits(const accel::NextHits& hits, int i, uint32_t lanes, Work& work) {
  uint32_t taken = 0;
  for (; lanes; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    if (hits.count(lane) <= i) continue;
    const accel::NextHits::Hit& hit = hits.at(lane, i);
    accel::RayPacket& packet = work.packet;
    packet.tFar[lane] = hit.distance, packet.u[lane] = hit.u, packet.v[lane] = hit.v;
    packet.instance[lane] = hit.instance, packet.primitive[lane] = hit.primitive;
    taken |= 1u << lane;
  }
  return taken;
}

/// Visits all hits of the packet's rays front to back. end(lanes, depths) returns the lanes that end before
/// this hit, put(lanes, colours, depths) those that need no further hits. The pixels' depth becomes the first
/// hit's.
template <class End, class Put>
HWY_ATTR void walkLayers(const FrameData& frame, Work& work, End&& end, Put&& put) {
  uint32_t ended = 0;
  const auto take = [&](uint32_t lanes, const LitRows& rows, const float* depth) HWY_ATTR {
    const uint32_t behind = end(lanes, depth);
    ended |= behind;
    lanes &= ~behind;
    for (uint32_t first = lanes; first; first &= first - 1) {
      const int i = std::countr_zero(first);
      if (work.depth[i] == Image::kMiss) work.depth[i] = depth[i];
    }
    ended |= put(lanes, rows, depth);
  };
  accel::NextHits hits;
  alignas(64) float passed[kLanes] = {};
  for (uint32_t lanes = work.hits; lanes;) {
    for (int i = 0; i < kLanes; ++i) work.valid[i] = lanes >> i & 1 ? -1 : 0;
    const accel::ImpostorQuery* impostors = aimRays(frame, work);
    for (int i = 0; i < kLanes; ++i) work.packet.tNear[i] = std::max(work.packet.tNear[i], passed[i]);
    frame.world->intersectNext(work.valid, work.packet, hits, impostors, work.coherence());
    for (int i = 0; i < accel::NextHits::kMax; ++i) {
      work.hits = takeHits(hits, i, lanes & ~ended, work);
      if (!work.hits) break;
      fetchVertices(frame, work);
      shadeHits(frame, work.hits, true, work, take);
    }
    uint32_t more = 0;
    for (lanes &= ~ended; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      if (!hits.full(i)) continue;
      passed[i] = hits.passOn(i);
      more |= 1u << i;
    }
    lanes = more;
  }
}

/// Counts the layers of the packet's pixels; neighbours mostly have equal counts.
HWY_ATTR inline void countLayers(const FrameData& frame, const scene::Layers& layers, const Work& work,
                                 const Gathered& g) {
  if (frame.remote && frame.remote->isReplaying()) return;  // counted the first time
  for (int i = 0; i < kLanes;) {
    const uint8_t places = g.places[i];
    if (places < 2) {
      ++i;
      continue;
    }
    const bool before = layers.opaqueDepth[pixelOf(frame, work, i)] >= 0;
    uint32_t same = 1;
    for (++i; i < kLanes && g.places[i] == places; ++i, ++same)
      if ((layers.opaqueDepth[pixelOf(frame, work, i)] >= 0) != before) break;
    frame.layerCounts[before][places].fetch_add(same, std::memory_order_relaxed);
  }
}

/// Stores the fragments of `lanes` in work.peeled, before they are composited.
HWY_ATTR inline void keepLayers(const FrameData& frame, uint32_t lanes, const LitRows& rows,
                                const float* depth, float tolerance, const Gathered& g, Work& work) {
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const uint64_t order = frame.surfaces[work.packet.instance[i]].instance->order;
    const float opacity = rows.value[3][i];
    const PeeledLayer layer{
        order << 32 | work.packet.primitive[i],
        {rows.value[0][i] * opacity, rows.value[1][i] * opacity, rows.value[2][i] * opacity, opacity}};
    if (std::abs(depth[i] - g.place[i]) <= tolerance)
      work.peeled.join(i, layer);
    else
      work.peeled.add(i, layer);
  }
}

/// The lanes with more layers than peels: layers behind the peels may be drawn over those in front.
inline uint32_t lanesWithRest(uint32_t lanes, uint32_t peels, const Work& work) {
  uint32_t rest = 0;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (work.peeled.count(i) > peels) rest |= 1u << i;
  }
  return rest;
}

/// Composites the pixels with more layers than the peels take.
HWY_ATTR inline void mixRest(const FrameData& frame, const scene::Layers& layers, Work& work, Gathered& g) {
  for (int i = 0; i < kLanes; ++i) {
    if (work.peeled.count(i) <= layers.peels) continue;
    const bool before = layers.opaqueDepth[pixelOf(frame, work, i)] >= 0;
    const size_t nearest = layers.peels, farthest = nearest - before;
    if (work.peeled.count(i) <= nearest + farthest + 1) continue;  // a single rest layer has no order
    const std::array<float, 4> mixed = work.peeled.mixed(i, nearest, farthest);
    for (size_t c = 0; c < 4; ++c) g.now[c][i] = mixed[c];
  }
}

/// Composites all hits of the packet's rays.
HWY_ATTR inline void compositeLayers(const FrameData& frame, const scene::Layers& layers, Work& work) {
  Gathered g;
  for (float& place : g.place) place = -1;
  work.cover = {g.now[3], g.before[3], g.place, layers.tolerance};
  if (layers.peels) work.peeled.clear();
  const auto end = [&](uint32_t lanes, const float* depth)
                       HWY_ATTR { return lanesBehind(layers, frame, work, lanes, depth); };
  walkLayers(frame, work, end, [&](uint32_t lanes, const LitRows& rows, const float* depth) HWY_ATTR {
    if (layers.peels) keepLayers(frame, lanes, rows, depth, layers.tolerance, g, work);
    putBehind(lanes, rows, depth, layers.tolerance, g, !frame.features);
    return lanesFull(layers.peels ? lanes & ~lanesWithRest(lanes, layers.peels, work) : lanes, g);
  });
  countLayers(frame, layers, work, g);
  if (layers.peels) mixRest(frame, layers, work, g);
  LitRows rows;
  for (int c = 0; c < 4; ++c) std::copy_n(g.now[c], kLanes, rows.value[c]);
  if (frame.bytes) return packColors(rows, work.color);
  for (int c = 0; c < 4; ++c) std::copy_n(rows.value[c], kLanes, work.wide[c]);
}

inline bool areOrdered(const FrameData& frame) {
  return frame.snapshot->settings.transparency == Transparency::ordered;
}

/// Sums whose mean colour, rgb/sum of opacities, is that of the layers over each other, with the same total
/// opacity.
HWY_ATTR inline void sumOrdered(const FrameData& frame, const scene::Layers& layers, Work& work) {
  Gathered g;
  for (float& place : g.place) place = -1;
  work.cover = {g.now[3], g.before[3], g.place, layers.tolerance};
  const auto end = [&](uint32_t lanes, const float* depth)
                       HWY_ATTR { return lanesBehind(layers, frame, work, lanes, depth); };
  EdgeHits edges(frame);
  walkLayers(frame, work, end, [&](uint32_t lanes, const LitRows& rows, const float* depth) HWY_ATTR {
    lanes &= ~edges.again(lanes, work.packet);
    putBehind(lanes, rows, depth, layers.tolerance, g, !frame.features);
    for (; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      work.wide[3][i] += rows.value[3][i];
    }
    return 0u;
  });
  for (int i = 0; i < kLanes; ++i) {
    if (!(g.now[3][i] > 0)) continue;
    for (int c = 0; c < 3; ++c) work.wide[c][i] = g.now[c][i] * (work.wide[3][i] / g.now[3][i]);
    work.through[i] = 1 - g.now[3][i];
  }
}

/// Of layers whose order is not known: their own opacity decides.
inline constexpr float kUncovered[kLanes] = {};

/// Sums all hits of the packet's rays.
HWY_ATTR inline void sumLayers(const FrameData& frame, const scene::Layers& layers, Work& work) {
  if (areOrdered(frame)) return sumOrdered(frame, layers, work);
  EdgeHits edges(frame);
  work.cover = {kUncovered};
  const auto end = [&](uint32_t lanes, const float* depth)
                       HWY_ATTR { return lanesBehind(layers, frame, work, lanes, depth); };
  walkLayers(frame, work, end, [&](uint32_t lanes, const LitRows& rows, const float*) HWY_ATTR {
    lanes &= ~edges.again(lanes, work.packet);
    for (int i = 0; i < kLanes; i += lanesOfVector()) {
      const Float opacity = hn::IfThenElseZero(lanesAt(lanes, i), load(rows.value[3] + i));
      for (int c = 0; c < 3; ++c) {
        const Float color = hn::IfThenElseZero(lanesAt(lanes, i), load(rows.value[c] + i));
        store(hn::MulAdd(color, opacity, load(work.wide[c] + i)), work.wide[c] + i);
      }
      store(hn::Add(load(work.wide[3] + i), opacity), work.wide[3] + i);
      store(hn::NegMulAdd(load(work.through + i), opacity, load(work.through + i)), work.through + i);
    }
    return 0u;
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
