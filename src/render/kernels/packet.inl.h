// The packet pipeline from rays to pixels, and the tile loop. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_PACKET_INL_H_
#undef GLURAY_RENDER_PACKET_INL_H_
#else
#define GLURAY_RENDER_PACKET_INL_H_
#endif

#include "render/kernels/averages.inl.h"
#include "render/kernels/feature_averages.inl.h"
#include "render/kernels/relight.inl.h"
#include "render/kernels/seen.inl.h"
#include "render/tiles/tile.h"
#include "render/visibility/multisample.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

// Last stage: writes colour and depth into the image, or adds them to the averages.
template <class Sums>
HWY_ATTR void finishWork(const FrameData& frame, const Tile& tile, const GrownSamples& grown, Work& work,
                         CollectedHits& behind, Sums* averages) {
  const bool keeps = frame.hits && !frame.caughtOcclusion;
  if (keeps) forgetHits(*frame.hits, work);
  clearPixels(averages ? 0 : frame.image->missColor, work);
  if (frame.grown && !work.lens) pickEdged(frame, grown, work);
  if (frame.leastDepth && !work.lens) pickLeastDepth(frame, centersOf(work), behind, work);
  if (work.hits && frame.snapshot->layers)
    shadeLayers(frame, *frame.snapshot->layers, work);
  else if (work.hits)
    shadeNearest(frame, work);
  if (frame.lamps && !frame.hits && !frame.features) showLamps(frame, work);
  if (averages)
    averages->add(frame, tile, work);
  else if (!keeps)
    storePixels(work, tile, *frame.image);
}

/// Pipelines three packets, each a stage apart, so that the prefetches of one stage complete while others
/// compute.
template <class Sums>
HWY_ATTR void traceSamples(const FrameData& frame, const Tile& tile, Sums* averages, WaitingPoints* waiting) {
  Work works[3];
  CollectedHits behind;  // scratch, for one packet at a time
  for (Work& work : works) initPacket(work.packet), work.waiting = waiting, work.colors = !frame.hits;
  GrownSamples grown(frame.grown.get(), tile,
                     2);  // a sample's last packets are finished while the next one is traced
  int count = 0;
  const bool layered = frame.snapshot->layers != nullptr;  // layers are traced in the last stage
  const auto back = [&](int stages) HWY_ATTR -> Work& { return works[(count - stages) % 3]; };
  for (int sample = 0; sample < static_cast<int>(frame.samplePositions.size()); ++sample) {
    if (!frame.lens || sample == 0) grown.find(sample);
    for (int y = tile.y0; y < tile.y1; y += 4) {
      for (int x = tile.x0; x < tile.x1; x += 4, ++count) {
        aim(frame, tile, x, y, sample, back(0));
        traceWork(frame, back(0));
        if (count > 0 && !layered) fetchVertices(frame, back(1));
        if (count > 1) finishWork(frame, tile, grown, back(2), behind, averages);
      }
    }
  }
  if (count > 0 && !layered) fetchVertices(frame, back(1));
  if (count > 1) finishWork(frame, tile, grown, back(2), behind, averages);
  if (count > 0) finishWork(frame, tile, grown, back(1), behind, averages);
}

HWY_ATTR void traceTile(const FrameData& frame, const Tile& tile, WaitingPoints* waiting) {
  if (frame.oncePerPixel) return traceMultisampled(frame, tile);
  if (frame.features && (frame.averages || frame.snapshot->layers)) {
    FeatureAverages features;
    traceSamples(frame, tile, &features, waiting);
    return features.store(frame, tile);
  }
  if (!frame.averages) return traceSamples<Averages>(frame, tile, nullptr, waiting);
  Averages averages;
  traceSamples(frame, tile, &averages, waiting);
  averages.store(frame, tile);
}

const char* targetName() { return hwy::TargetName(HWY_TARGET); }

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
