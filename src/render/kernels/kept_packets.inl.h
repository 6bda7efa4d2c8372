// Loop over the packets of a tile whose hits are known. Part of kernels.cpp (compiled once for each
// instruction set).
#if defined(GLURAY_RENDER_KEPT_PACKETS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_KEPT_PACKETS_INL_H_
#undef GLURAY_RENDER_KEPT_PACKETS_INL_H_
#else
#define GLURAY_RENDER_KEPT_PACKETS_INL_H_
#endif

#include "render/packets/kept_hits.inl.h"
#include "render/packets/pixels.inl.h"
#include "render/packets/trace.inl.h"
#include "render/tiles/tile.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Calls color() for each packet of a tile, with its hits from `buffer` in `work`, as if its rays had just
/// been traced. Pipelined as the first pass is, but no rays are traced meanwhile: the stages are several
/// packets apart, because memory takes longer than colours.
template <class Color>
HWY_ATTR HWY_INLINE void eachKeptPacket(const FrameData& frame, const HitBuffer& buffer, const Tile& tile,
                                        Work& work, Color&& color) {
  constexpr int kApart = 2;  // packets
  const int columns = (tile.x1 - tile.x0 + 3) / 4, count = columns * ((tile.y1 - tile.y0 + 3) / 4);
  const auto xOf = [&](int packet) { return tile.x0 + packet % columns * 4; };
  const auto yOf = [&](int packet) { return tile.y0 + packet / columns * 4; };
  struct Corners {
    alignas(64) uint32_t vertex[3][kLanes];
  };
  Corners fetched[kApart];  // of the packets that are coloured next
  initPacket(work.packet);
  for (int first = 0; first < count + 2 * kApart; ++first) {
    if (const int last = first - 2 * kApart; last >= 0) {
      aim(frame, tile, xOf(last), yOf(last), 0, work);
      recall(buffer, work);
      std::memcpy(work.vertex, fetched[last % kApart].vertex, sizeof work.vertex);
      color();
    }
    if (const int second = first - kApart; second >= 0 && second < count) {
      const size_t at = buffer.at(xOf(second), yOf(second));
      fetchVertices(frame, buffer.lanes[at].shown, buffer.hits[at].instance, buffer.hits[at].primitive,
                    fetched[second % kApart].vertex);
    }
    if (first < count) {
      const size_t at = buffer.at(xOf(first), yOf(first));
      prefetchTriangles(frame, buffer.lanes[at].shown, buffer.hits[at].instance, buffer.hits[at].primitive);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
