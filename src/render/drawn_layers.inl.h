// Surfaces that are blended in the order of drawing (scene::Layers::Of::drawn): what is drawn to a pixel,
// fragment after fragment. Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_DRAWN_LAYERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_DRAWN_LAYERS_INL_H_
#undef GLURAY_RENDER_DRAWN_LAYERS_INL_H_
#else
#define GLURAY_RENDER_DRAWN_LAYERS_INL_H_
#endif

#include "render/blend.h"
#include "render/layers.inl.h"

#include <tuple>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// A fragment of one of a packet's pixels.
struct DrawnFragment {
  uint32_t lane, order, primitive;  // order: of its instance
  uint32_t color;                   // RGBA8
  float depth;
  bool operator<(const DrawnFragment& o) const {
    return std::tie(lane, order, primitive) < std::tie(o.lane, o.order, o.primitive);
  }
};

/// The depth test as a framebuffer of so many steps does it. Depths that come to one step are equal; those
/// that were rounded on their way through floats are within a quarter of the finest.
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

/// Everything that the packet's rays hit and that may pass the depth test.
HWY_ATTR inline void gatherDrawn(const FrameData& frame, const scene::Layers& layers, Work& work,
                                 std::vector<DrawnFragment>& fragments) {
  const scene::Snapshot& s = *frame.snapshot;
  // Along a ray depth grows, but for what offsets add to single triangles.
  const bool grows = s.polygonOffset == scene::PolygonOffset{} && s.camera.depthNear <= s.camera.depthFar;
  const float reach = grows ? static_cast<float>(1 / std::max(layers.depthSteps, 1.0)) + 0x1p-24f : 2.0f;
  EdgeHits edges;
  alignas(64) uint32_t colors[kLanes];
  const auto end = [&](uint32_t lanes, const float* depth)
                       HWY_ATTR { return lanesBehind(layers, frame, work, lanes, depth, reach); };
  walkLayers(frame, work, end, [&](uint32_t lanes, const LitRows& rows, const float* depth) HWY_ATTR {
    lanes &= ~edges.again(lanes, work.packet);
    packColors(rows, colors);
    for (; lanes; lanes &= lanes - 1) {
      const int i = std::countr_zero(lanes);
      const uint32_t order = frame.surfaces[work.packet.instance[i]].instance->order;
      fragments.push_back({static_cast<uint32_t>(i), order, work.packet.primitive[i], colors[i], depth[i]});
    }
    return 0u;
  });
}

/// Colour and depth as they are when all fragments have been drawn; where none has passed, a miss.
HWY_ATTR inline void blendLayers(const FrameData& frame, const scene::Layers& layers, Work& work) {
  std::vector<DrawnFragment> fragments;
  gatherDrawn(frame, layers, work, fragments);
  std::sort(fragments.begin(), fragments.end());
  for (float& depth : work.depth) depth = Image::kMiss;
  const DrawnDepthTest test(layers.depthSteps, frame.snapshot->laterWins);
  for (auto f = fragments.begin(); f != fragments.end();) {
    const auto lane = static_cast<int>(f->lane);
    const size_t pixel = pixelOf(frame, work, lane);
    float depth = layers.opaqueDepth[pixel];
    uint32_t color = layers.colors[pixel];
    bool drawn = false;
    for (; f != fragments.end() && f->lane == static_cast<uint32_t>(lane); ++f) {
      if (!test.passes(f->depth, depth)) continue;
      color = blended(layers.blending, frame.snapshot->colorWrites, f->color, color);
      if (layers.blending.writesDepth) depth = test.stored(f->depth);
      drawn = true;
    }
    if (drawn) work.color[lane] = color, work.depth[lane] = depth;
  }
}

HWY_ATTR inline void shadeLayers(const FrameData& frame, const scene::Layers& layers, Work& work) {
  switch (layers.of) {
    case scene::Layers::Of::order: return compositeLayers(frame, layers, work);
    case scene::Layers::Of::sums: return sumLayers(frame, layers, work);
    case scene::Layers::Of::drawn: return blendLayers(frame, layers, work);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
