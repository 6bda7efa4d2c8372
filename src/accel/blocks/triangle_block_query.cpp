// Embree's callbacks for triangle blocks. Called on tracing and building threads.
#include "accel/blocks/triangle_block_kernels.h"
#include "accel/blocks/triangle_blocks.h"
#include "accel/embree.h"
#include "accel/query_state.h"

#include <bit>

namespace gluray::accel {
namespace {

PacketRows rowsOf(const RTCIntersectFunctionNArguments& a) {
  RTCRayN* ray = RTCRayHitN_RayN(a.rayhit, a.N);
  RTCHitN* hit = RTCRayHitN_HitN(a.rayhit, a.N);
  PacketRows p;
  p.count = a.N, p.valid = a.valid;
  p.orgX = &RTCRayN_org_x(ray, a.N, 0), p.orgY = &RTCRayN_org_y(ray, a.N, 0),
  p.orgZ = &RTCRayN_org_z(ray, a.N, 0);
  p.dirX = &RTCRayN_dir_x(ray, a.N, 0), p.dirY = &RTCRayN_dir_y(ray, a.N, 0),
  p.dirZ = &RTCRayN_dir_z(ray, a.N, 0);
  p.tNear = &RTCRayN_tnear(ray, a.N, 0), p.tFar = &RTCRayN_tfar(ray, a.N, 0);
  p.normalX = &RTCHitN_Ng_x(hit, a.N, 0), p.normalY = &RTCHitN_Ng_y(hit, a.N, 0);
  p.normalZ = &RTCHitN_Ng_z(hit, a.N, 0), p.u = &RTCHitN_u(hit, a.N, 0), p.v = &RTCHitN_v(hit, a.N, 0);
  p.primitive = &RTCHitN_primID(hit, a.N, 0), p.geometry = &RTCHitN_geomID(hit, a.N, 0);
  p.instance = &RTCHitN_instID(hit, a.N, 0, 0);
  return p;
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

}  // namespace

void triangleBlockBounds(const RTCBoundsFunctionArguments* arguments) {
  const Box box = static_cast<const TriangleBlocks*>(arguments->geometryUserPtr)->boxOf(arguments->primID);
  RTCBounds& out = *arguments->bounds_o;
  out.lower_x = box.lower.x, out.lower_y = box.lower.y, out.lower_z = box.lower.z;
  out.upper_x = box.upper.x, out.upper_y = box.upper.y, out.upper_z = box.upper.z;
}

void intersectTriangleBlocks(const RTCIntersectFunctionNArguments* arguments) {
  const RTCIntersectFunctionNArguments& a = *arguments;
  const auto& blocks = *static_cast<const TriangleBlocks*>(a.geometryUserPtr);
  const scene::Mesh& mesh = blocks.mesh();
  const TriangleRun run{mesh.positions.data, mesh.positions.stride,
                        reinterpret_cast<const uint32_t*>(mesh.indices.data), blocks.first(a.primID),
                        blocks.first(a.primID + 1)};
  const HitNames names{a.geomID, a.context->instID[0]};
  const auto* state = static_cast<const QueryState*>(reinterpret_cast<const QueryContext*>(a.context)->user);
  const bool all = !state || !(state->filter || state->ties || state->next);
  if (all) return meetTriangles(run, rowsOf(a), names, nullptr, nullptr);
  const Query query{*state, a,
                    names.instance == RTC_INVALID_GEOMETRY_ID ? state->aloneIndex : names.instance};
  meetTriangles(run, rowsOf(a), names, choose, &query);
}

}  // namespace gluray::accel
