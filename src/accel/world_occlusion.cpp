// Occlusion queries of World.
#include "accel/device/embree.h"
#include "accel/queries/occlusion_state.h"
#include "accel/rays/occlusion.h"
#include "accel/rays/packet_parts.h"
#include "accel/rays/traceable.h"
#include "accel/world.h"

#include <cstddef>

namespace gluray::accel {
namespace {

// OcclusionRays is read and written by Embree in place.
static_assert(sizeof(RTCRay16) == sizeof(OcclusionRays));
static_assert(offsetof(OcclusionRays, tFar) == offsetof(RTCRay16, tfar));
static_assert(offsetof(OcclusionRays, flags) == offsetof(RTCRay16, flags));

void onOccluder(const RTCFilterFunctionNArguments* arguments) {
  const RTCFilterFunctionNArguments& a = *arguments;
  const auto& state =
      *static_cast<const OcclusionState*>(reinterpret_cast<const QueryContext*>(a.context)->user);
  for (unsigned i = 0; i < a.N; ++i) {
    if (a.valid[i] != -1) continue;
    const float t = RTCRayN_tfar(a.ray, a.N, i);
    const glm::vec3 org = originOf(a.ray, a.N, i), dir = directionOf(a.ray, a.N, i);
    const Occluder occluder{state.instanceOf(RTCHitN_instID(a.hit, a.N, i, 0)),
                            RTCHitN_primID(a.hit, a.N, i),
                            RTCHitN_u(a.hit, a.N, i),
                            RTCHitN_v(a.hit, a.N, i),
                            org + t * dir,
                            static_cast<int>(RTCRayN_id(a.ray, a.N, i))};
    if (!state.blocks(occluder)) a.valid[i] = 0;
  }
}

}  // namespace

uint32_t World::occluded(const int32_t* valid, OcclusionRays& rays, const OccluderFilter* filter,
                         RayKind kind) const noexcept {
  RTCSceneTy* const scene = lightScene(kind);
  if (!scene) return 0;
  alignas(64) int32_t lanes[kLanes];
  bool any = false;
  for (int i = 0; i < kLanes; ++i) {
    lanes[i] = valid[i] && isTraceable(rays, i) ? -1 : 0;
    any |= lanes[i] != 0;
    rays.time[i] = 0;
    rays.mask[i] = ~0u;
    rays.id[i] = static_cast<uint32_t>(i);
    rays.flags[i] = 0;
  }
  if (!any) return 0;
  const OcclusionState state{filter, aloneIndex_, impostors_.empty() ? nullptr : impostors_.data()};
  // Not the coherent traversal: that of Embree 3.13 for occlusion may not end (adr/0043).
  PacketQuery query(Coherence::incoherent, filter ? onOccluder : nullptr, &state);
  askInWidth<RTCRay16, RTCRay8, RTCRay4>(
      device_.packetWidth(), rays, sizeof(RTCRay16) / (kLanes * sizeof(float)), lanes,
      [&](const int32_t* asked, auto& packet) { query.occluded(asked, scene, packet); });
  uint32_t blocked = 0;
  for (int i = 0; i < kLanes; ++i)
    if (lanes[i] && rays.tFar[i] < 0) blocked |= 1u << i;
  return blocked;
}

}  // namespace gluray::accel
