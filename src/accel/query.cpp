// Queries of World: Embree's packets, in the width that the processor handles natively.
#include "accel/embree.h"
#include "accel/world.h"

#include <cstddef>
#include <cstring>

namespace gluray::accel {
namespace {

// RayPacket is read and written by Embree in place.
static_assert(sizeof(RTCRayHit16) <= sizeof(RayPacket) && alignof(RayPacket) >= alignof(RTCRayHit16));
static_assert(offsetof(RayPacket, tFar) == offsetof(RTCRayHit16, ray.tfar));
static_assert(offsetof(RayPacket, normalX) == offsetof(RTCRayHit16, hit.Ng_x));
static_assert(offsetof(RayPacket, primitive) == offsetof(RTCRayHit16, hit.primID));
static_assert(offsetof(RayPacket, instance) == offsetof(RTCRayHit16, hit.instID));

/// What the filter callback needs; lives as long as one query.
struct FilterState {
  const HitFilter& filter;
  uint32_t aloneIndex;
};

void onFilter(const RTCFilterFunctionNArguments* arguments) {
  const auto& state =
      *static_cast<const FilterState*>(reinterpret_cast<const QueryContext*>(arguments->context)->user);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] != -1) continue;
    const uint32_t instance = RTCHitN_instID(arguments->hit, arguments->N, i, 0);
    const bool accepted = state.filter.accepts(
        instance == RTC_INVALID_GEOMETRY_ID ? state.aloneIndex : instance,
        RTCHitN_primID(arguments->hit, arguments->N, i), RTCHitN_u(arguments->hit, arguments->N, i),
        RTCHitN_v(arguments->hit, arguments->N, i),
        static_cast<int>(RTCRayN_id(arguments->ray, arguments->N, i)));
    if (!accepted) arguments->valid[i] = 0;
  }
}

// Rows of `From` and `To` hold one value for each ray; the narrow packet is lanes [first, first + width) of
// the wide one.
template <class Narrow, int width>
void intersectPart(CoherentQuery& query, RTCSceneTy* scene, const int32_t* valid, RayPacket& packet,
                   int first) {
  constexpr size_t kRows = offsetof(RayPacket, reserved) / (kLanes * sizeof(float));
  static_assert(sizeof(Narrow) >= kRows * width * sizeof(float));
  Narrow narrow;
  auto* wideRows = reinterpret_cast<std::byte*>(&packet) + static_cast<size_t>(first) * sizeof(float);
  auto* narrowRows = reinterpret_cast<std::byte*>(&narrow);
  const auto wideRow = [&](size_t row) { return wideRows + row * kLanes * sizeof(float); };
  const auto narrowRow = [&](size_t row) { return narrowRows + row * width * sizeof(float); };
  for (size_t row = 0; row < kRows; ++row) std::memcpy(narrowRow(row), wideRow(row), width * sizeof(float));
  alignas(64) int32_t narrowValid[width];
  std::memcpy(narrowValid, valid + first, sizeof(narrowValid));
  query.intersect(narrowValid, scene, narrow);
  for (size_t row = 0; row < kRows; ++row) std::memcpy(wideRow(row), narrowRow(row), width * sizeof(float));
}

void intersectAll(CoherentQuery& query, RTCSceneTy* scene, int width, const int32_t* valid,
                  RayPacket& packet) {
  if (width == 16) return query.intersect(valid, scene, reinterpret_cast<RTCRayHit16&>(packet));
  for (int first = 0; first < kLanes; first += width) {
    if (width == 8)
      intersectPart<RTCRayHit8, 8>(query, scene, valid, packet, first);
    else
      intersectPart<RTCRayHit4, 4>(query, scene, valid, packet, first);
  }
}

void nameLoneInstance(RayPacket& packet, uint32_t index) {
  for (uint32_t& instance : packet.instance) instance = index;
}

}  // namespace

void World::intersect(const int32_t* valid, RayPacket& packet) const noexcept {
  CoherentQuery query;
  intersectAll(query, scene_, device_.packetWidth(), valid, packet);
  if (alone_) nameLoneInstance(packet, aloneIndex_);
}

void World::intersect(const int32_t* valid, RayPacket& packet, const HitFilter& filter) const noexcept {
  const FilterState state{filter, aloneIndex_};
  CoherentQuery query(onFilter, &state);
  intersectAll(query, scene_, device_.packetWidth(), valid, packet);
  if (alone_) nameLoneInstance(packet, aloneIndex_);
}

}  // namespace gluray::accel
