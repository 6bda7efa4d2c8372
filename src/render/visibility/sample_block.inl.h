// Hits of all samples of a packet's pixels in a multisampled framebuffer, and which samples share a triangle.
// Part of kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_SAMPLE_BLOCK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_SAMPLE_BLOCK_INL_H_
#undef GLURAY_RENDER_SAMPLE_BLOCK_INL_H_
#else
#define GLURAY_RENDER_SAMPLE_BLOCK_INL_H_
#endif

#include "render/packets/pixels.inl.h"
#include "render/tiles/tile.h"
#include "render/visibility/edges.inl.h"
#include "render/visibility/least_depth.inl.h"

#include <memory>
#include <utility>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

struct Distances {
  alignas(64) Row of = {};
};

/// All samples of a packet's pixels.
struct SampleBlock {
  std::vector<Work> samples;
  Centers centers;
  CollectedHits behind;  // scratch, for one sample at a time
  // Per sample; bit i: lane i.
  std::vector<uint32_t> open;    // has a hit that is not shaded yet
  std::vector<uint32_t> failed;  // has a hit that was rejected
  std::vector<uint32_t>
      shared;  // [sample * count + earlier]: shows the same triangle as the earlier sample, which is shaded
  std::vector<std::unique_ptr<RejectingFilter>> filters;  // of samples whose rays continue
  std::vector<Distances> passed;                          // distances that their rays have passed

  explicit SampleBlock(size_t count)
      : samples(count), open(count), failed(count), shared(count * count), filters(count), passed(count) {
    for (Work& work : samples) initPacket(work.packet);
  }
  size_t count() const { return samples.size(); }
  uint32_t& sharedBy(size_t sample, size_t earlier) { return shared[sample * count() + earlier]; }
};

/// Lanes in which two packets hit the same triangle.
HWY_ATTR inline uint32_t lanesOfSameHit(const accel::RayPacket& a, const accel::RayPacket& b) {
  const IndexTag d;
  uint32_t lanes = 0;
  for (int i = 0; i < kLanes; i += lanesOfVector()) {
    const auto same = hn::And(hn::Eq(hn::Load(d, a.instance + i), hn::Load(d, b.instance + i)),
                              hn::Eq(hn::Load(d, a.primitive + i), hn::Load(d, b.primitive + i)));
    lanes |= bitsAt(same, i);
  }
  return lanes;
}

/// Finds the open samples of each pixel that show the same triangle; the first one is shaded for all of them.
HWY_ATTR inline void shareHits(const FrameData& frame, SampleBlock& block) {
  for (size_t s = 0; s < block.count(); ++s) {
    uint32_t rest = block.open[s];
    for (size_t t = 0; t < s; ++t) {
      const uint32_t first = rest & block.sharedBy(t, t);
      const uint32_t same =
          first ? first & lanesOfSameHit(block.samples[t].packet, block.samples[s].packet) : 0;
      block.sharedBy(s, t) = same;
      rest &= ~same;
    }
    block.sharedBy(s, s) = rest;
    fetchVertices(frame, rest, block.samples[s]);
  }
}

/// Lanes of a sample whose hit is clipped by the instance's own planes.
HWY_ATTR inline uint32_t cutLanes(const FrameData& frame, const Centers& centers, const Work& work) {
  uint32_t cut = 0;
  const accel::RayPacket& packet = work.packet;
  for (uint32_t lanes = work.hits; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    if (frame.surfaces[packet.instance[i]].ownClipPlanes &&
        !isLeft(frame, packet.instance[i], packet.primitive[i], packet.u[i], packet.v[i], &centers, i))
      cut |= 1u << i;
  }
  return cut;
}

/// Continues failed lanes' rays behind their hits; new hits make lanes open. Whether any lane had failed.
HWY_ATTR inline bool traceFailed(const FrameData& frame, SampleBlock& block) {
  bool any = false;
  for (size_t s = 0; s < block.count(); ++s) {
    const uint32_t lanes = std::exchange(block.failed[s], 0);
    block.open[s] = 0;
    if (!lanes) continue;
    any = true;
    Work& work = block.samples[s];
    work.edged &= ~lanes;
    if (!block.filters[s]) {
      block.filters[s] = std::make_unique<RejectingFilter>(frame, &block.centers);
      block.passed[s] = {};
    }
    traceOn(frame, lanes, *block.filters[s], block.passed[s].of, work);
    block.open[s] = work.hits;
  }
  return any;
}

// First stage: traces all samples of the 4x4 pixels from image pixel (x, y) on.
HWY_ATTR inline void traceBlock(const FrameData& frame, const Tile& tile, int x, int y, SampleBlock& block) {
  for (size_t s = 0; s < block.count(); ++s) {
    aim(frame, tile, x, y, static_cast<int>(s), block.samples[s]);
    traceWork(frame, block.samples[s]);
  }
  block.centers = centersOf(block.samples[0]);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
