// Surfaces that are seen through (scene::Layers): all that a packet's rays hit, composited from the front.
// Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_LAYERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_LAYERS_INL_H_
#undef GLURAY_RENDER_LAYERS_INL_H_
#else
#define GLURAY_RENDER_LAYERS_INL_H_
#endif

#include "render/edges.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// What the rays of a packet have gathered. Rows: colours weighted by opacity, and the opacity of all.
struct Gathered {
  alignas(64) Row before[4] = {};  // the fragments at one place, which are under way
  alignas(64) Row now[4] = {};     // with them
  float place[kLanes];             // their depth
};

/// Puts the fragments of `lanes` behind what is there.
HWY_ATTR inline void putBehind(uint32_t lanes, const LitRows& rows, const float* depth, float tolerance,
                               Gathered& g) {
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (!(std::abs(depth[i] - g.place[i]) <= tolerance)) {
      for (int c = 0; c < 4; ++c) g.before[c][i] = g.now[c][i];
      g.place[i] = depth[i];
    }
    const float weight = (1 - g.before[3][i]) * rows.value[3][i];
    for (int c = 0; c < 4; ++c) {
      const float added = g.before[c][i] + weight * (c < 3 ? rows.value[c][i] : 1);
      g.now[c][i] = std::clamp(added, g.now[c][i], std::max(g.now[c][i], 1.0f));
    }
  }
}

/// The lanes whose fragment lies behind what is opaque, and those that let nothing more through.
HWY_ATTR inline uint32_t lanesAtEnd(const scene::Layers& layers, const FrameData& frame, const Work& work,
                                    uint32_t lanes, const float* depth, const Gathered& g) {
  constexpr float kNothing = 0.5f / 255;  // less is not seen
  uint32_t ended = 0;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const size_t pixel =
        static_cast<size_t>(work.imageY + laneY(i)) * static_cast<size_t>(frame.image->width) +
        static_cast<size_t>(work.imageX + laneX(i));
    const float opaque = layers.opaqueDepth[pixel];
    if ((opaque >= 0 && depth[i] > opaque) || g.now[3][i] > 1 - kNothing) ended |= 1u << i;
  }
  return ended;
}

/// All hits of the packet's rays, composited. Depth is that of the first.
HWY_ATTR inline void shadeLayers(const FrameData& frame, const scene::Layers& layers, Work& work) {
  Gathered g;
  for (float& place : g.place) place = -1;
  RejectingFilter filter(frame);
  alignas(64) float passed[kLanes] = {};
  uint32_t ended = 0;
  const auto take = [&](uint32_t lanes, const LitRows& rows, const float* depth) HWY_ATTR {
    const uint32_t behind = lanesAtEnd(layers, frame, work, lanes, depth, g);
    ended |= behind;
    lanes &= ~behind;
    for (uint32_t first = lanes; first; first &= first - 1) {
      const int i = std::countr_zero(first);
      if (work.depth[i] == Image::kMiss) work.depth[i] = depth[i];
    }
    putBehind(lanes, rows, depth, layers.tolerance, g);
  };
  const bool ask = frame.world->mayCoincide();
  bool asked = false;
  for (uint32_t lanes = work.hits; lanes; asked = ask) {
    shadeHits(frame, lanes, !asked, work, take);
    lanes &= ~ended;
    if (!lanes) break;
    if (ask)
      traceOn(frame, lanes, filter, passed, work);
    else
      traceBehind(frame, lanes, work);
    lanes &= work.hits;
  }
  LitRows rows;
  for (int c = 0; c < 4; ++c) std::copy_n(g.now[c], kLanes, rows.value[c]);
  packColors(rows, work.color);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
