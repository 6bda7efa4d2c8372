// Hits of a moving frame: kept while their factors of light are traced, recalled to be coloured. Part of
// kernels.cpp (compiled once for each instruction set).
#if defined(GLURAY_RENDER_KEPT_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLURAY_RENDER_KEPT_HITS_INL_H_
#undef GLURAY_RENDER_KEPT_HITS_INL_H_
#else
#define GLURAY_RENDER_KEPT_HITS_INL_H_
#endif

#include "render/moving/hit_film.h"
#include "render/packets/hits.inl.h"

HWY_BEFORE_NAMESPACE();
namespace gluray::render {
namespace HWY_NAMESPACE {

/// Keeps the hits of `lanes`.
HWY_ATTR inline void keepHits(HitFilm& film, uint32_t lanes, const Work& work) {
  const size_t at = film.at(work.imageX, work.imageY);
  PacketHits& hits = film.hits[at];
  for (uint32_t rest = lanes; rest; rest &= rest - 1) {
    const int i = std::countr_zero(rest);
    hits.instance[i] = work.packet.instance[i], hits.primitive[i] = work.packet.primitive[i];
    hits.u[i] = work.packet.u[i], hits.v[i] = work.packet.v[i];
    if (!film.edgeDepth.empty()) film.edgeDepth[at * kLanes + static_cast<size_t>(i)] = work.edgeDepth[i];
  }
  film.lanes[at].shown |= lanes;
  film.lanes[at].edged |= lanes & work.edged;
}

/// Before the packet's hits are kept.
HWY_ATTR inline void forgetHits(HitFilm& film, const Work& work) {
  film.lanes[film.at(work.imageX, work.imageY)] = {};
}

/// First stage of the second pass: the hits of a packet, as if its rays had just been traced.
HWY_ATTR inline void recall(const HitFilm& film, Work& work) {
  const size_t at = film.at(work.imageX, work.imageY);
  const HitFilm::Lanes lanes = film.lanes[at];
  work.hits = lanes.shown;
  if (!work.hits) return;
  const PacketHits& hits = film.hits[at];
  std::memcpy(work.packet.instance, hits.instance, sizeof hits.instance);
  std::memcpy(work.packet.primitive, hits.primitive, sizeof hits.primitive);
  std::memcpy(work.packet.u, hits.u, sizeof hits.u), std::memcpy(work.packet.v, hits.v, sizeof hits.v);
  if (!film.edgeDepth.empty())
    std::memcpy(work.edgeDepth, film.edgeDepth.data() + at * kLanes, sizeof work.edgeDepth);
}

}  // namespace HWY_NAMESPACE
}  // namespace gluray::render
HWY_AFTER_NAMESPACE();
#endif
