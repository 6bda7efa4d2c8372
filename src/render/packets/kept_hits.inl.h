// Hits of a moving frame: kept while their visibility is traced, recalled to be coloured. Part of
// kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_KEPT_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_KEPT_HITS_INL_H_
#undef GLURAY_RENDER_KEPT_HITS_INL_H_
#else
#define GLURAY_RENDER_KEPT_HITS_INL_H_
#endif

#include "render/moving/hit_buffer.h"
#include "render/packets/hits.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Keeps the hits of `lanes`.
HWY_ATTR inline void keepHits(HitBuffer& buffer, uint32_t lanes, const Work& work) {
  const size_t at = buffer.at(work.imageX, work.imageY);
  PacketHits& hits = buffer.hits[at];
  for (uint32_t rest = lanes; rest; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    hits.instance[i] = work.packet.instance[i], hits.primitive[i] = work.packet.primitive[i];
    hits.u[i] = work.packet.u[i], hits.v[i] = work.packet.v[i];
    if (!buffer.edgeDepth.empty()) buffer.edgeDepth[at * kLanes + static_cast<size_t>(i)] = work.edgeDepth[i];
  }
  HitBuffer::Lanes& kept = buffer.lanes[at];
  kept.shown = static_cast<uint16_t>(kept.shown | lanes);
  kept.edged = static_cast<uint16_t>(kept.edged | (lanes & work.edged));
}

/// Before the packet's hits are kept.
HWY_ATTR inline void forgetHits(HitBuffer& buffer, const Work& work) {
  buffer.lanes[buffer.at(work.imageX, work.imageY)] = {};
}

/// First stage of a later pass: the hits of a packet, as if its rays had just been traced.
HWY_ATTR inline void recall(const HitBuffer& buffer, Work& work) {
  const size_t at = buffer.at(work.imageX, work.imageY);
  const HitBuffer::Lanes lanes = buffer.lanes[at];
  work.hits = lanes.shown;
  if (!work.hits) return;
  const PacketHits& hits = buffer.hits[at];
  std::memcpy(work.packet.instance, hits.instance, sizeof hits.instance);
  std::memcpy(work.packet.primitive, hits.primitive, sizeof hits.primitive);
  std::memcpy(work.packet.u, hits.u, sizeof hits.u), std::memcpy(work.packet.v, hits.v, sizeof hits.v);
  if (!buffer.edgeDepth.empty())
    std::memcpy(work.edgeDepth, buffer.edgeDepth.data() + at * kLanes, sizeof work.edgeDepth);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
