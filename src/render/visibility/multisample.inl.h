// Multisampling as in OpenGL: each sample has its own coverage and depth, but a triangle is shaded once per
// pixel, at the pixel's centre, covered or not (GL 4.6, 14.3.1). Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_MULTISAMPLE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_MULTISAMPLE_INL_H_
#undef GLURAY_RENDER_MULTISAMPLE_INL_H_
#else
#define GLURAY_RENDER_MULTISAMPLE_INL_H_
#endif

#include "render/tiles/tile.h"
#include "render/visibility/sample_block.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Moves the points of triangles that grew by their edges to the pixels' centres; sets their depth there.
HWY_ATTR inline void moveEdgedToCenters(const FrameData& frame, const Surface& s, const Centers& centers,
                                        uint32_t lanes, Group& group, float* depth) {
  const DepthMap& map = frame.depth;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const EdgedTriangle triangle(s, frame.snapshot->camera, group.primitive[i]);
    const glm::dvec2 at(centers.x[i], centers.y[i]);
    const glm::vec2 weights = triangle.weights(at);
    group.u[i] = weights.x, group.v[i] = weights.y;
    const double ndc = triangle.ndcDepth(at);
    depth[i] = static_cast<float>(std::clamp(ndc * map.scale + map.offset + map.constant, 0.0, 1.0));
  }
}

/// Shading results of a group.
struct Shown {
  Group group;
  DepthAndFacing seen;  // at the centres
  PlaneRows planes;
  LitRows rows;
  alignas(64) uint32_t color[kLanes];
  bool oneDepth = false;  // the centre's depth holds for all samples
};

/// Depths of `lanes` at a sample, which is offset by `shift` from the pixels' centres.
HWY_ATTR inline void depthsOfSample(const FrameData& frame, const Surface& s, const Shown& shown,
                                    const glm::dvec2& shift, uint32_t lanes, const Work& work, float* out) {
  const DoubleTag d;
  const DepthMap& map = frame.depth;
  uint32_t doubtful = 0;
  for (int i = 0; i < kLanes; i += static_cast<int>(hn::Lanes(d))) {
    const Double ndc = hn::MulAdd(hn::Set(d, shift.x), hn::Load(d, shown.planes.slopeX + i),
                                  hn::MulAdd(hn::Set(d, shift.y), hn::Load(d, shown.planes.slopeY + i),
                                             hn::Load(d, shown.planes.ndc + i)));
    const Double depth = hn::Add(hn::MulAdd(ndc, hn::Set(d, map.scale), hn::Set(d, map.offset)),
                                 hn::Load(d, shown.planes.offset + i));
    storeFloat(hn::Min(hn::Max(depth, hn::Zero(d)), hn::Set(d, 1.0)), out + i);
    uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Not(hn::Le(hn::Abs(ndc), hn::Set(d, 1.0 + 1e-6))), bits);
    doubtful |= static_cast<uint32_t>(bits[0]) << i;
  }
  for (doubtful &= lanes; doubtful; doubtful &= doubtful - 1) {
    const int i = std::countr_zero(doubtful);
    out[i] = depthFromCorners(s, map, shown.group.primitive[i], work.packet.u[i], work.packet.v[i]);
  }
}

/// Writes the group's colours and depths into all samples from `first` on that show it.
HWY_ATTR inline void spread(const FrameData& frame, const Surface& s, size_t first, Shown& shown,
                            SampleBlock& block) {
  const bool wide = frame.image->has(Plane::wideColor);
  const IndexTag d;
  if (!wide) packColors(shown.rows, shown.color);
  alignas(64) float depth[kLanes];
  for (size_t sample = first; sample < block.count(); ++sample) {
    const uint32_t lanes = block.sharedBy(sample, first) & shown.group.lanes;
    if (!lanes) continue;
    Work& work = block.samples[sample];
    const glm::dvec2 shift = frame.samplePositions[sample] - 0.5;
    if (!shown.oneDepth) depthsOfSample(frame, s, shown, shift, lanes, work, depth);
    blendRow(lanes, shown.oneDepth ? shown.seen.depth : depth, work.depth);
    if (!shown.oneDepth) blendRow(lanes & work.edged, work.edgeDepth, work.depth);
    for (int c = 0; wide && c < 4; ++c) blendRow(lanes, shown.rows.value[c], work.wide[c]);
    for (int i = 0; !wide && i < kLanes; i += lanesOfVector())
      hn::Store(hn::IfThenElse(maskAt(lanes, i), hn::Load(d, shown.color + i), hn::Load(d, work.color + i)),
                d, work.color + i);
  }
}

/// Points, depths and facing of a group of sample `first`, at the pixels' centres.
HWY_ATTR inline void locate(const FrameData& frame, uint32_t instance, size_t first, SampleBlock& block,
                            Shown& shown) {
  const Surface& s = frame.surfaces[instance];
  const Centers& centers = block.centers;
  loadCorners(*s.mesh, shown.group);
  shown.oneDepth = s.lighting->shading->fragment.writesDepth;
  if (s.mesh->shape == scene::Shape::triangles) {
    const uint32_t edged = block.samples[first].edged & shown.group.lanes;
    computeDepth(frame, s, shown.group, centers.x, centers.y, shown.seen, &shown.planes);
    moveToSamples(shown.seen, 0, shown.group);
    moveEdgedToCenters(frame, s, centers, edged, shown.group, shown.seen.depth);
    return;
  }
  shown.oneDepth = true;
  if (scene::isInWindow(s.mesh->shape))
    computePixelImpostors(s, frame.world->impostorsOf(instance), centers.x, centers.y, shown.group,
                          shown.seen);
  else if (scene::isSolid(s.mesh->shape))
    computeCapsules(s, frame.world->impostorsOf(instance), frame.depth, centers.x, centers.y, shown.group,
                    shown.seen);
  else if (s.mesh->shape == scene::Shape::sticks)
    computeSticks(s, frame.world->impostorsOf(instance), frame.depth, centers.x, centers.y, true, shown.group,
                  shown.seen);
  else
    computeImpostors(s, frame.depth, Pinhole(), centers.x, centers.y, shown.group, shown.seen);
}

/// Shades the triangles that sample `first` is the first to show. Returns the lanes whose hit is rejected:
/// culled (tested only if `mayReject`), or failing the alpha test.
HWY_ATTR inline uint32_t shadeFirst(const FrameData& frame, size_t first, bool mayReject,
                                    SampleBlock& block) {
  uint32_t rejected = 0;
  Work& work = block.samples[first];
  Shown shown;
  for (uint32_t lanes = block.sharedBy(first, first); lanes;) {
    gather(work, lanes, shown.group);
    lanes &= ~shown.group.lanes;
    const uint32_t instance = work.packet.instance[std::countr_zero(shown.group.lanes)];
    const Surface& s = frame.surfaces[instance];
    locate(frame, instance, first, block, shown);
    const uint32_t ccw = shown.seen.ccw;
    const uint32_t culled =
        mayReject ? ((s.cullsCcw ? ccw : 0) | (s.cullsCw ? ~ccw : 0)) & shown.group.lanes : 0;
    rejected |= culled;
    shown.group.lanes &= ~culled;
    if (shown.group.lanes == 0) continue;
    const uint32_t back = (s.frontIsCcw ? ~ccw : ccw) & shown.group.lanes;
    const uint32_t failing = shade(frame, s, shown.group, back, block.centers.x, block.centers.y, shown.rows);
    rejected |= failing;
    shown.group.lanes &= ~failing;
    if (frame.changesColors())
      lightHits(frame, instance, shown.group, back, 0, block.centers.x, block.centers.y, shown.rows);
    spread(frame, s, first, shown, block);
  }
  return rejected;
}

/// Shades all open lanes; rejected ones become failed.
HWY_ATTR inline void shadeOpen(const FrameData& frame, bool mayReject, SampleBlock& block) {
  for (size_t t = 0; t < block.count(); ++t) {
    if (!block.sharedBy(t, t)) continue;
    const uint32_t rejected = shadeFirst(frame, t, mayReject, block);
    for (size_t s = t; rejected && s < block.count(); ++s) block.failed[s] |= block.sharedBy(s, t) & rejected;
  }
}

// Second stage: finds the samples that share a triangle; prefetches the vertices.
HWY_ATTR inline void shareBlock(const FrameData& frame, const GrownSamples& grown, SampleBlock& block) {
  for (size_t s = 0; s < block.count(); ++s) {
    Work& work = block.samples[s];
    clearPixels(frame.image->missColor, work);
    block.filters[s].reset();
    if (frame.grown) pickEdged(frame, grown, work);
    if (frame.leastDepth) pickLeastDepth(frame, block.centers, block.behind, work);
    block.failed[s] = frame.ownPlanes ? cutLanes(frame, block.centers, work) : 0;
    block.open[s] = work.hits & ~block.failed[s];
  }
  shareHits(frame, block);
}

// Last stage: writes colours and depths into the image.
HWY_ATTR inline void finishBlock(const FrameData& frame, const Tile& tile, SampleBlock& block) {
  shadeOpen(frame, true, block);
  while (traceFailed(frame, block)) {
    shareHits(frame, block);
    shadeOpen(frame, false, block);
  }
  for (Work& work : block.samples) {
    if (frame.lamps) showLamps(frame, work);
    storePixels(work, tile, *frame.image);
  }
}

/// Traces the tile in every sample plane. Pipelines three blocks, each a stage apart.
HWY_ATTR inline void traceMultisampled(const FrameData& frame, const Tile& tile) {
  std::vector<SampleBlock> blocks;
  blocks.reserve(3);
  for (int i = 0; i < 3; ++i) blocks.emplace_back(frame.samplePositions.size());
  const auto samples = static_cast<int>(frame.samplePositions.size());
  GrownSamples grown(frame.grown.get(), tile, samples);
  for (int sample = 0; sample < samples; ++sample) grown.find(sample);
  int count = 0;
  const auto back = [&](int stages) HWY_ATTR -> SampleBlock& {
    return blocks[static_cast<size_t>((count - stages) % 3)];
  };
  for (int y = tile.y0; y < tile.y1; y += 4) {
    for (int x = tile.x0; x < tile.x1; x += 4, ++count) {
      traceBlock(frame, tile, x, y, back(0));
      if (count > 0) shareBlock(frame, grown, back(1));
      if (count > 1) finishBlock(frame, tile, back(2));
    }
  }
  if (count > 0) shareBlock(frame, grown, back(1));
  if (count > 1) finishBlock(frame, tile, back(2));
  if (count > 0) finishBlock(frame, tile, back(1));
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
