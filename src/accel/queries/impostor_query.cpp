#include "accel/queries/impostor_query.h"

#include "accel/device/embree.h"
#include "accel/impostors/capsule.h"
#include "accel/impostors/capsule_bundles.h"
#include "accel/impostors/pixel_impostor.h"
#include "accel/impostors/solid.h"
#include "accel/impostors/solid_guess.h"
#include "accel/impostors/stick.h"
#include "accel/queries/occlusion_state.h"
#include "accel/queries/query_state.h"

#include <bit>
#include <limits>

namespace gluray::accel {
namespace {

/// The active lanes of Embree's call, which are consecutive lanes of the packet.
template <class Arguments>
uint32_t lanesAsked(const Arguments& a) {
  uint32_t lanes = 0;
  for (unsigned i = 0; i < a.N; ++i)
    if (a.valid[i] == -1) lanes |= 1u << i;
  return lanes;
}

/// Returns which of `lanes` hit the impostor, and sets their t.
uint32_t lanesThatMeet(const QueryState& state, uint32_t instance, uint32_t primitive, uint32_t lanes,
                       float (&t)[kLanes]) {
  const PlacedImpostors& placed = state.impostors[instance];
  const ImpostorQuery& rays = state.rays;
  if (scene::isInWindow(placed.mesh->shape)) return meet(placed, primitive, rays, state.around, lanes, t);
  Impostor impostor;
  Capsule capsule;
  Stick stick;
  const bool solid = scene::isSolid(placed.mesh->shape), isStick = placed.mesh->shape == scene::Shape::sticks;
  if (!(isStick ? Stick::make(placed, primitive, stick)
        : solid ? Capsule::make(placed, primitive, capsule)
                : Impostor::make(placed, primitive, impostor)))
    return 0;
  const bool apart = rays.samples != rays.centers;
  if (state.raysOf != instance) {
    toLighting(placed, *rays.centers, state.centers);
    if (apart) toLighting(placed, *rays.samples, state.samples);
    state.raysOf = instance;
  }
  if (isStick) return meet(stick, state.centers, lanes, t);
  if (solid) return meet(placed, capsule, apart ? state.samples : state.centers, lanes, t);
  return meet(impostor, state.centers, apart ? state.samples : state.centers, lanes, t);
}

ObjectRay rayOf(RTCRayN* ray, unsigned count, unsigned i) {
  return {originOf(ray, count, i), directionOf(ray, count, i), RTCRayN_tnear(ray, count, i),
          RTCRayN_tfar(ray, count, i)};
}

/// Nothing for a single ray and a ball, whose test takes no longer than the guess.
SolidGuess guess(const PlacedImpostors& placed, uint32_t primitive, const RTCRayN* rays, unsigned count,
                 uint32_t lanes) {
  const scene::Shape shape = placed.mesh->shape;
  if (std::has_single_bit(lanes) && (shape == scene::Shape::spheres || shape == scene::Shape::beads))
    return {};
  const std::optional<RoundHull> hull = hullOf(placed, primitive);
  if (!hull) return {};
  return guessSolid(placed, *hull, reinterpret_cast<const float*>(rays), count, lanes);
}

/// Hits of rays that do not come from the viewpoint.
void intersectSolids(const RTCIntersectFunctionNArguments& a, const QueryState& state, uint32_t instance,
                     uint32_t primitive, uint32_t lanes) {
  const PlacedImpostors& placed = state.impostors[instance];
  RTCRayN* ray = RTCRayHitN_RayN(a.rayhit, a.N);
  RTCHitN* hit = RTCRayHitN_HitN(a.rayhit, a.N);
  lanes &= ~guess(placed, primitive, ray, a.N, lanes).misses;
  for (; lanes; lanes &= lanes - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(lanes));
    const std::optional<SolidHit> met = meetSolid(placed, primitive, rayOf(ray, a.N, i));
    if (!met) continue;
    float distance = met->t;
    if (!state.counts(static_cast<int>(RTCRayN_id(ray, a.N, i)), instance, primitive, 0, 0, distance))
      continue;
    RTCRayN_tfar(ray, a.N, i) = distance;
    RTCHitN_Ng_x(hit, a.N, i) = met->normal.x, RTCHitN_Ng_y(hit, a.N, i) = met->normal.y,
                           RTCHitN_Ng_z(hit, a.N, i) = met->normal.z;
    RTCHitN_u(hit, a.N, i) = RTCHitN_v(hit, a.N, i) = 0;
    RTCHitN_primID(hit, a.N, i) = primitive, RTCHitN_geomID(hit, a.N, i) = a.geomID;
    RTCHitN_instID(hit, a.N, i, 0) = a.context->instID[0];
  }
}

/// Hits of rays from the viewpoint. `lanes`: of Embree's call.
void intersectSeen(const RTCIntersectFunctionNArguments& a, const QueryState& state, uint32_t instance,
                   uint32_t primitive, uint32_t lanes) {
  RTCRayN* ray = RTCRayHitN_RayN(a.rayhit, a.N);
  RTCHitN* hit = RTCRayHitN_HitN(a.rayhit, a.N);
  const uint32_t first = RTCRayN_id(ray, a.N, 0);
  alignas(64) float t[kLanes];
  uint32_t met = lanesThatMeet(state, instance, primitive, lanes << first, t);
  for (; met; met &= met - 1) {
    const auto lane = static_cast<uint32_t>(std::countr_zero(met));
    const unsigned i = lane - first;
    float distance = t[lane];
    if (!(distance >= RTCRayN_tnear(ray, a.N, i) && distance < RTCRayN_tfar(ray, a.N, i))) continue;
    if (!state.counts(static_cast<int>(lane), instance, primitive, 0, 0, distance)) continue;
    RTCRayN_tfar(ray, a.N, i) = distance;
    RTCHitN_Ng_x(hit, a.N, i) = RTCHitN_Ng_y(hit, a.N, i) = RTCHitN_Ng_z(hit, a.N, i) = 0;
    RTCHitN_u(hit, a.N, i) = RTCHitN_v(hit, a.N, i) = 0;
    RTCHitN_primID(hit, a.N, i) = primitive;
    RTCHitN_geomID(hit, a.N, i) = a.geomID;
    RTCHitN_instID(hit, a.N, i, 0) = a.context->instID[0];
  }
}

/// Calls meet(state, instance) unless the query asks for no impostors.
template <class Meet>
void withQuery(const RTCIntersectFunctionNArguments& a, Meet&& meet) {
  const auto* state = static_cast<const QueryState*>(reinterpret_cast<const QueryContext*>(a.context)->user);
  if (!state || !state->impostors) return;
  const uint32_t inside = a.context->instID[0];
  meet(*state, inside == RTC_INVALID_GEOMETRY_ID ? state->aloneIndex : inside);
}

void intersectOne(const RTCIntersectFunctionNArguments& a, const QueryState& state, uint32_t instance,
                  uint32_t primitive, uint32_t lanes) {
  if (state.rays.centers)
    intersectSeen(a, state, instance, primitive, lanes);
  else
    intersectSolids(a, state, instance, primitive, lanes);
}

/// Returns which of `lanes` an impostor blocks.
uint32_t occludeOne(const RTCOccludedFunctionNArguments& a, const OcclusionState& state, uint32_t instance,
                    uint32_t primitive, uint32_t lanes) {
  const PlacedImpostors& placed = state.impostors[instance];
  const SolidGuess sure = guess(placed, primitive, a.ray, a.N, lanes);
  const uint32_t met = state.filter && state.filter->usesPoints() ? 0 : sure.hits;
  uint32_t blocked = 0;
  const auto meetAt = [&](unsigned i, const glm::vec3& point) {
    const Occluder occluder{instance, primitive, 0, 0, point, static_cast<int>(RTCRayN_id(a.ray, a.N, i))};
    if (!state.blocks(occluder)) return;
    RTCRayN_tfar(a.ray, a.N, i) = -std::numeric_limits<float>::infinity();
    blocked |= 1u << i;
  };
  for (uint32_t hits = met; hits; hits &= hits - 1) meetAt(static_cast<unsigned>(std::countr_zero(hits)), {});
  for (lanes &= ~(sure.misses | met); lanes; lanes &= lanes - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(lanes));
    const ObjectRay ray = rayOf(a.ray, a.N, i);
    if (const std::optional<SolidHit> hit = meetSolid(placed, primitive, ray))
      meetAt(i, ray.org + hit->t * ray.dir);
  }
  return blocked;
}

template <class Meet>
void withQuery(const RTCOccludedFunctionNArguments& a, Meet&& meet) {
  const auto* state =
      static_cast<const OcclusionState*>(reinterpret_cast<const QueryContext*>(a.context)->user);
  if (state && state->impostors) meet(*state, state->instanceOf(a.context->instID[0]));
}

const CapsuleBundle& bundleOf(void* bundles, unsigned primitive) {
  return (*static_cast<const CapsuleBundles*>(bundles))[primitive];
}

}  // namespace

void occludeImpostors(const RTCOccludedFunctionNArguments* arguments) {
  const RTCOccludedFunctionNArguments& a = *arguments;
  withQuery(a, [&](const OcclusionState& state, uint32_t instance) {
    occludeOne(a, state, instance, a.primID, lanesAsked(a));
  });
}

void intersectImpostors(const RTCIntersectFunctionNArguments* arguments) {
  const RTCIntersectFunctionNArguments& a = *arguments;
  withQuery(a, [&](const QueryState& state, uint32_t instance) {
    intersectOne(a, state, instance, a.primID, lanesAsked(a));
  });
}

void capsuleBundleBounds(const RTCBoundsFunctionArguments* arguments) {
  const Box box = static_cast<const CapsuleBundles*>(arguments->geometryUserPtr)->boxOf(arguments->primID);
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = box.lower.x, out.lower_y = box.lower.y, out.lower_z = box.lower.z;
  out.upper_x = box.upper.x, out.upper_y = box.upper.y, out.upper_z = box.upper.z;
}

void occludeCapsuleBundles(const RTCOccludedFunctionNArguments* arguments) {
  const RTCOccludedFunctionNArguments& a = *arguments;
  withQuery(a, [&](const OcclusionState& state, uint32_t instance) {
    const CapsuleBundle& bundle = bundleOf(a.geometryUserPtr, a.primID);
    uint32_t open = lanesAsked(a), near[CapsuleBundle::kMost];
    nearCapsules(bundle, state.impostors[instance], reinterpret_cast<const float*>(a.ray), a.N, open, near);
    for (uint32_t k = 0; k < bundle.count && open; ++k)
      if (const uint32_t lanes = near[k] & open)
        open &= ~occludeOne(a, state, instance, bundle.primitive[k], lanes);
  });
}

void intersectCapsuleBundles(const RTCIntersectFunctionNArguments* arguments) {
  const RTCIntersectFunctionNArguments& a = *arguments;
  withQuery(a, [&](const QueryState& state, uint32_t instance) {
    const CapsuleBundle& bundle = bundleOf(a.geometryUserPtr, a.primID);
    const auto* rays = reinterpret_cast<const float*>(RTCRayHitN_RayN(a.rayhit, a.N));
    uint32_t near[CapsuleBundle::kMost];
    nearCapsules(bundle, state.impostors[instance], rays, a.N, lanesAsked(a), near);
    for (uint32_t k = 0; k < bundle.count; ++k)
      if (near[k]) intersectOne(a, state, instance, bundle.primitive[k], near[k]);
  });
}

}  // namespace gluray::accel
