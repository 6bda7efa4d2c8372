// Embree's callbacks for triangle blocks and bundles. Called on tracing and building threads.
#include "accel/blocks/triangle_block_bounds.h"
#include "accel/blocks/triangle_blocks.h"
#include "accel/blocks/triangle_bundles.h"
#include "accel/device/embree.h"
#include "accel/queries/occlusion_state.h"
#include "accel/queries/query_state.h"

#include <bit>

namespace gluray::accel {
namespace {

void readRays(RTCRayN* ray, unsigned count, const int* valid, PacketRows& p) {
  p.count = count, p.valid = valid;
  p.orgX = &RTCRayN_org_x(ray, count, 0), p.orgY = &RTCRayN_org_y(ray, count, 0),
  p.orgZ = &RTCRayN_org_z(ray, count, 0);
  p.dirX = &RTCRayN_dir_x(ray, count, 0), p.dirY = &RTCRayN_dir_y(ray, count, 0),
  p.dirZ = &RTCRayN_dir_z(ray, count, 0);
  p.tNear = &RTCRayN_tnear(ray, count, 0), p.tFar = &RTCRayN_tfar(ray, count, 0);
}

PacketRows rowsOf(const RTCIntersectFunctionNArguments& a) {
  RTCHitN* hit = RTCRayHitN_HitN(a.rayhit, a.N);
  PacketRows p;
  readRays(RTCRayHitN_RayN(a.rayhit, a.N), a.N, a.valid, p);
  p.normalX = &RTCHitN_Ng_x(hit, a.N, 0), p.normalY = &RTCHitN_Ng_y(hit, a.N, 0);
  p.normalZ = &RTCHitN_Ng_z(hit, a.N, 0), p.u = &RTCHitN_u(hit, a.N, 0), p.v = &RTCHitN_v(hit, a.N, 0);
  p.primitive = &RTCHitN_primID(hit, a.N, 0), p.geometry = &RTCHitN_geomID(hit, a.N, 0);
  p.instance = &RTCHitN_instID(hit, a.N, 0, 0);
  return p;
}

TriangleRun runOf(const TriangleBlocks& blocks, uint32_t block) {
  return trianglesOf(blocks.mesh(), blocks.first(block), blocks.first(block + 1));
}

struct Query {
  const QueryState& state;
  const RTCIntersectFunctionNArguments& arguments;
  uint32_t instance;
};

uint32_t choose(const void* query, const PacketRows& rows, const MetTriangle& met) {
  const auto& [state, a, instance] = *static_cast<const Query*>(query);
  const RTCRayN* ray = RTCRayHitN_RayN(a.rayhit, a.N);
  uint32_t chosen = 0;
  for (uint32_t left = met.rays; left; left &= left - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(left));
    const unsigned i = met.first + lane;
    float distance = met.t[lane];
    const auto id = static_cast<int>(RTCRayN_id(const_cast<RTCRayN*>(ray), a.N, i));
    if (!state.counts(id, instance, met.triangle, met.u[lane], met.v[lane], distance)) continue;
    rows.tFar[i] = distance;
    chosen |= 1u << lane;
  }
  return chosen;
}

struct OcclusionAsked {
  const OcclusionState& state;
  const RTCOccludedFunctionNArguments& arguments;
  uint32_t instance;
};

uint32_t chooseBlocked(const void* query, const PacketRows& rows, const MetTriangle& met) {
  const auto& [state, a, instance] = *static_cast<const OcclusionAsked*>(query);
  uint32_t chosen = 0;
  for (uint32_t left = met.rays; left; left &= left - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(left));
    const unsigned i = met.first + lane;
    const glm::vec3 org(rows.orgX[i], rows.orgY[i], rows.orgZ[i]),
        dir(rows.dirX[i], rows.dirY[i], rows.dirZ[i]);
    const Occluder occluder{instance,
                            met.triangle,
                            met.u[lane],
                            met.v[lane],
                            org + met.t[lane] * dir,
                            static_cast<int>(RTCRayN_id(a.ray, a.N, i))};
    if (state.blocks(occluder)) chosen |= 1u << lane;
  }
  return chosen;
}

void setBounds(const Box& box, RTCBounds& out) {
  out.lower_x = box.lower.x, out.lower_y = box.lower.y, out.lower_z = box.lower.z;
  out.upper_x = box.upper.x, out.upper_y = box.upper.y, out.upper_z = box.upper.z;
}

/// Calls meet(packet, names, chooser, query) for the nearest hits.
template <class Meet>
void intersect(const RTCIntersectFunctionNArguments& a, Meet&& meet) {
  const HitNames names{a.geomID, a.context->instID[0]};
  const auto* state = static_cast<const QueryState*>(reinterpret_cast<const QueryContext*>(a.context)->user);
  const bool all = !state || !(state->filter || state->ties || state->next);
  if (all) return meet(rowsOf(a), names, nullptr, nullptr);
  const Query query{*state, a,
                    names.instance == RTC_INVALID_GEOMETRY_ID ? state->aloneIndex : names.instance};
  meet(rowsOf(a), names, choose, &query);
}

/// Calls meet(packet, chooser, query) to find rays that are blocked.
template <class Meet>
void occlude(const RTCOccludedFunctionNArguments& a, Meet&& meet) {
  PacketRows rows{};
  readRays(a.ray, a.N, a.valid, rows);
  const auto* state =
      static_cast<const OcclusionState*>(reinterpret_cast<const QueryContext*>(a.context)->user);
  if (!state || !state->filter) return meet(rows, nullptr, nullptr);
  const OcclusionAsked asked{*state, a, state->instanceOf(a.context->instID[0])};
  meet(rows, chooseBlocked, &asked);
}

}  // namespace

void triangleBlockBounds(const RTCBoundsFunctionArguments* a) {
  setBounds(static_cast<const TriangleBlocks*>(a->geometryUserPtr)->boxOf(a->primID), *a->bounds_o);
}

void intersectTriangleBlocks(const RTCIntersectFunctionNArguments* arguments) {
  const TriangleRun run =
      runOf(*static_cast<const TriangleBlocks*>(arguments->geometryUserPtr), arguments->primID);
  intersect(*arguments, [&](const PacketRows& rows, const HitNames& names, Chooser chooser,
                            const void* query) { meetTriangles(run, rows, names, chooser, query); });
}

void occludeTriangleBlocks(const RTCOccludedFunctionNArguments* arguments) {
  const TriangleRun run =
      runOf(*static_cast<const TriangleBlocks*>(arguments->geometryUserPtr), arguments->primID);
  occlude(*arguments, [&](const PacketRows& rows, Chooser chooser, const void* query) {
    occludeTriangles(run, rows, chooser, query);
  });
}

void triangleBundleBounds(const RTCBoundsFunctionArguments* a) {
  setBounds(static_cast<const TriangleBundles*>(a->geometryUserPtr)->boxOf(a->primID), *a->bounds_o);
}

void intersectTriangleBundles(const RTCIntersectFunctionNArguments* arguments) {
  const auto& bundles = *static_cast<const TriangleBundles*>(arguments->geometryUserPtr);
  intersect(*arguments,
            [&](const PacketRows& rows, const HitNames& names, Chooser chooser, const void* query) {
              meetBundle(bundles[arguments->primID], bundles.arrays(), rows, names, chooser, query);
            });
}

void occludeTriangleBundles(const RTCOccludedFunctionNArguments* arguments) {
  const auto& bundles = *static_cast<const TriangleBundles*>(arguments->geometryUserPtr);
  occlude(*arguments, [&](const PacketRows& rows, Chooser chooser, const void* query) {
    occludeBundle(bundles[arguments->primID], bundles.arrays(), rows, chooser, query);
  });
}

}  // namespace gluray::accel
