// Layers that are blended in the order of drawing (scene::Layers::Of::drawn), fragment by fragment. Part of
// kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_DRAWN_LAYERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_DRAWN_LAYERS_INL_H_
#undef GLURAY_RENDER_DRAWN_LAYERS_INL_H_
#else
#define GLURAY_RENDER_DRAWN_LAYERS_INL_H_
#endif

#include "render/layers/blend.inl.h"
#include "render/layers/layers.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// The depth test of a framebuffer with `steps` depth steps. Depths in one step are equal; float rounding
/// moves them by less than a quarter of the finest step.
class DrawnDepthTest {
 public:
  DrawnDepthTest(double steps, bool laterWins) : steps_(steps) {
    constexpr float kFloat = 0x1p-26f;
    const auto half = static_cast<float>(0.5 / (steps > 0 ? steps : 0x1p24));
    margin_ = laterWins ? half + kFloat : -half - kFloat;
    equalPasses_ = laterWins;
  }
  bool passes(float depth, float there) const {
    return equalPasses_ ? depth <= there + margin_ : depth < there + margin_;
  }
  float stored(float depth) const {
    const double d = std::clamp(depth, 0.0f, 1.0f);
    return static_cast<float>(steps_ > 0 ? std::round(d * steps_) / steps_ : d);
  }

 private:
  double steps_;
  float margin_;
  bool equalPasses_;
};

/// Gathers all hits of the packet's rays that may pass the depth test.
HWY_ATTR inline void gatherDrawn(const FrameData& frame, const scene::Layers& layers, Work& work) {
  work.fragments.clear();
  if (layers.blending.rgb.source == scene::BlendFactor::sourceAlpha) work.cover = {kUncovered};
  const scene::Snapshot& s = *frame.snapshot;
  // Depth grows along a ray, except for polygon offsets of single triangles.
  const bool grows = s.polygonOffset == scene::PolygonOffset{} && s.camera.depthNear <= s.camera.depthFar;
  const float reach = grows ? static_cast<float>(1 / std::max(layers.depthSteps, 1.0)) + 0x1p-24f : 2.0f;
  EdgeHits edges(frame);
  alignas(64) uint32_t colors[kLanes] = {};
  const auto end = [&](uint32_t lanes, const float* depth)
                       HWY_ATTR { return lanesBehind(layers, frame, work, lanes, depth, reach); };
  walkLayers(frame, work, end, [&](uint32_t lanes, const LitRows& rows, const float* depth) HWY_ATTR {
    lanes &= ~edges.again(lanes, work.packet);
    if (frame.bytes) packColors(rows, colors);
    for (; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      const uint64_t order = frame.surfaces[work.packet.instance[i]].instance->order;
      const DrawnFragment fragment{order << 32 | work.packet.primitive[i], depth[i], colors[i]};
      if (frame.bytes)
        work.fragments.add(i, fragment);
      else
        work.fragments.add(i, fragment,
                           {rows.value[0][i], rows.value[1][i], rows.value[2][i], rows.value[3][i]});
    }
    return 0u;
  });
}

/// Copies the framebuffer's colours of the packet's pixels.
HWY_ATTR inline void fetchThere(const FrameData& frame, const scene::Layers& layers, const Work& work,
                                Row (&there)[4]) {
  for (uint32_t rest = work.hits; rest; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    const size_t pixel = pixelOf(frame, work, i);
    for (int c = 0; c < 4; ++c)
      there[c][i] = frame.bytes ? static_cast<float>(layers.colors[pixel] >> (8 * c) & 255)
                                : layers.floatColors[pixel][c];
  }
}

/// Blends one fragment of each of `lanes` into `there`. `color`: their colours, or the numbers of these.
HWY_ATTR inline void blendOne(const FrameData& frame, const scene::Layers& layers, const Work& work,
                              uint32_t lanes, const uint32_t* color, Row (&there)[4]) {
  const scene::ColorWrites& writes = frame.snapshot->colorWrites;
  if (frame.bytes) return blendRows(layers.blending, writes, lanes, color, there);
  alignas(64) Row source[4] = {};
  for (uint32_t rest = lanes; rest; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    for (size_t c = 0; c < 4; ++c) source[c][i] = work.fragments.floats(color[i])[c];
  }
  if (layers.halfFloats)
    blendFloats<HalfChannels>(layers.blending, writes, lanes, source, there);
  else
    blendFloats<FloatChannels>(layers.blending, writes, lanes, source, there);
}

/// The pixels' colours become those of `drawn` lanes.
HWY_ATTR inline void takeBlended(const FrameData& frame, uint32_t drawn, const Row (&there)[4], Work& work) {
  for (; drawn; drawn &= drawn - 1) {
    const int i = std::countr_zero(drawn);
    work.color[i] = 0;
    for (int c = 0; c < 4; ++c) {
      if (frame.bytes)
        work.color[i] |= static_cast<uint32_t>(there[c][i]) << (8 * c);
      else
        work.wide[c][i] = there[c][i];
    }
  }
}

/// Blends all fragments into colour and depth; pixels where none passes are misses. Ordered fragments do not
/// hide each other by depth, and the nearest of them becomes the pixel's.
HWY_ATTR inline void blendLayers(const FrameData& frame, const scene::Layers& layers, Work& work) {
  const uint32_t lanes = work.hits;
  const bool ordered = areOrdered(frame);
  alignas(64) Row there[4] = {};
  fetchThere(frame, layers, work, there);
  gatherDrawn(frame, layers, work);
  const DrawnDepthTest test(layers.depthSteps, frame.snapshot->laterWins);
  if (ordered)
    work.fragments.sortBackToFront([&](float z) { return test.stored(z); });
  else
    work.fragments.sort();
  alignas(64) float stored[kLanes] = {}, depth[kLanes] = {};
  alignas(64) uint32_t color[kLanes] = {};
  for (uint32_t rest = lanes; rest; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    stored[i] = layers.opaqueDepth[pixelOf(frame, work, i)];
  }
  alignas(64) float final[kLanes];
  std::copy_n(stored, kLanes, final);
  uint32_t drawn = 0;
  for (size_t n = 0;; ++n) {
    const uint32_t any = work.fragments.nth(n, depth, color);
    if (!any) break;
    uint32_t passing = 0;
    for (uint32_t rest = any; rest; rest &= rest - 1) {
      const int i = std::countr_zero(rest);
      if (!test.passes(depth[i], stored[i])) continue;
      passing |= 1u << i;
      if (!layers.blending.writesDepth) continue;
      final[i] = test.stored(depth[i]);
      if (!ordered) stored[i] = final[i];
    }
    if (passing) blendOne(frame, layers, work, passing, color, there);
    drawn |= passing;
  }
  for (int i = 0; i < kLanes; ++i) work.depth[i] = drawn >> i & 1 ? final[i] : Image::kMiss;
  takeBlended(frame, drawn, there, work);
}

HWY_ATTR inline void shadeLayers(const FrameData& frame, const scene::Layers& layers, Work& work) {
  switch (layers.of) {
    case scene::Layers::Of::order: compositeLayers(frame, layers, work); break;
    case scene::Layers::Of::sums: sumLayers(frame, layers, work); break;
    case scene::Layers::Of::drawn: blendLayers(frame, layers, work); break;
  }
  work.cover = {};
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
