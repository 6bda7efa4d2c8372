// World's ray queries, as Embree packets of the width that the processor supports natively.
#include "accel/device/embree.h"
#include "accel/queries/query_state.h"
#include "accel/rays/packet_parts.h"
#include "accel/world.h"

#include <cstddef>

namespace gluray::accel {
namespace {

// Embree reads and writes RayPacket in place.
static_assert(sizeof(RTCRayHit16) <= sizeof(RayPacket) && alignof(RayPacket) >= alignof(RTCRayHit16));
static_assert(offsetof(RayPacket, tFar) == offsetof(RTCRayHit16, ray.tfar));
static_assert(offsetof(RayPacket, normalX) == offsetof(RTCRayHit16, hit.Ng_x));
static_assert(offsetof(RayPacket, primitive) == offsetof(RTCRayHit16, hit.primID));
static_assert(offsetof(RayPacket, instance) == offsetof(RTCRayHit16, hit.instID));

bool counts(const QueryState& state, const RTCFilterFunctionNArguments& a, unsigned i) {
  uint32_t instance = RTCHitN_instID(a.hit, a.N, i, 0);
  if (instance == RTC_INVALID_GEOMETRY_ID) instance = state.aloneIndex;
  const auto lane = static_cast<int>(RTCRayN_id(a.ray, a.N, i));
  return state.counts(lane, instance, RTCHitN_primID(a.hit, a.N, i), RTCHitN_u(a.hit, a.N, i),
                      RTCHitN_v(a.hit, a.N, i), RTCRayN_tfar(a.ray, a.N, i));
}

void onFilter(const RTCFilterFunctionNArguments* arguments) {
  const auto& state =
      *static_cast<const QueryState*>(reinterpret_cast<const QueryContext*>(arguments->context)->user);
  for (unsigned i = 0; i < arguments->N; ++i)
    if (arguments->valid[i] == -1 && !counts(state, *arguments, i)) arguments->valid[i] = 0;
}

void intersectAll(PacketQuery& query, RTCSceneTy* scene, int width, const int32_t* valid, RayPacket& packet) {
  constexpr size_t kRows = offsetof(RayPacket, reserved) / (kLanes * sizeof(float));
  askInWidth<RTCRayHit16, RTCRayHit8, RTCRayHit4>(
      width, packet, kRows, valid,
      [&](const int32_t* lanes, auto& rays) { query.intersect(lanes, scene, rays); });
}

void nameLoneInstance(RayPacket& packet, uint32_t index) {
  for (uint32_t& instance : packet.instance) instance = index;
}

}  // namespace

void World::ask(QueryState& state, bool filtered, const int32_t* valid, RayPacket& packet,
                const ImpostorQuery* impostors, Coherence coherence) const noexcept {
  if (impostors) {
    state.impostors = impostors_.data(), state.rays = *impostors;
    if (hasPixelImpostors_ && impostors->samples) state.around = WindowRectangle(*impostors->samples);
  }
  PacketQuery query(coherence, filtered ? onFilter : nullptr, &state);
  intersectAll(query, scene_, device_.packetWidth(), valid, packet);
}

void World::intersect(const int32_t* valid, RayPacket& packet, const HitFilter* filter,
                      const ImpostorQuery* impostors, Coherence coherence) const noexcept {
  if (!scene_) return ground_.intersect(valid, packet);
  if (!filter && !mayCoincide_ && !impostors) {
    PacketQuery query(coherence);
    intersectAll(query, scene_, device_.packetWidth(), valid, packet);
  } else {
    TieBreaker ties(order_);
    QueryState state{filter, mayCoincide_ ? &ties : nullptr, aloneIndex_};
    ask(state, filter || mayCoincide_, valid, packet, impostors, coherence);
    if (mayCoincide_) ties.restoreDistances(packet);
  }
  if (alone_) nameLoneInstance(packet, aloneIndex_);
  if (ground_.exists()) ground_.intersect(valid, packet);
}

void World::intersectNext(const int32_t* valid, RayPacket& packet, NextHits& hits,
                          const ImpostorQuery* impostors, Coherence coherence) const noexcept {
  if (!scene_) return;
  QueryState state{nullptr, nullptr, aloneIndex_};
  state.next = &hits;
  ask(state, true, valid, packet, impostors, coherence);
}

void World::intersectBounced(const int32_t* valid, RayPacket& packet) const noexcept {
  QueryState state{nullptr, nullptr, aloneIndex_};
  if (!impostors_.empty()) state.impostors = impostors_.data();
  PacketQuery query(Coherence::incoherent, nullptr, &state);
  RTCSceneTy* const scene = lightScene(RayKind::reflection);
  if (!scene) return;
  intersectAll(query, scene, device_.packetWidth(), valid, packet);
  if (alone_ && !light_.exists()) nameLoneInstance(packet, aloneIndex_);
}

}  // namespace gluray::accel
