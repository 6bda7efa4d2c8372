// Plans of draws whose positions only their vertex shader can compute.
#include "gl/culled/culled_draws.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"

#include <algorithm>

namespace gluray::gl {
namespace {

/// If so, the real OpenGL may read vertices that the draw does not name.
bool areAllInBuffers(const ArrayState& arrays) {
  bool all = true;
  const auto look = [&](const ArraySource& array) { all = all && (!array.enabled || array.buffer); };
  arrays.forEach(look);
  std::ranges::for_each(arrays.generic, look);
  return all;
}

}  // namespace

CullReason CulledDraws::planFeedback(Plan& found) {
  ShadowState& shadow = p_.shadow;
  const Elements& e = found.elements;
  CulledProgram& program = programInUse();
  if (found.samples > 1 && program.usesCentroids()) return CullReason::multisampleState;
  if (isOn(shadow.real, GL_BLEND))
    if (const CullReason reason = blendingOf(program, {}, found.mode, e); reason != CullReason::culled)
      return reason;
  const ArrayState& arrays = shadow.attributes();
  if (arrays.reason == Reason::deletedBuffer) return CullReason::deletedBuffer;
  if (!areAllInBuffers(arrays) || !areAllInBuffers(shadow.arrays()) || (e.type && !arrays.elements))
    return CullReason::arrayState;
  ArrayState content;
  content.elements = arrays.elements;
  if (e.type && foreignReason(content) != Reason::traced) return CullReason::foreignBuffer;
  shadow.errors.keepPending();
  found.program = &program, found.feedback = &program.feedback();
  if (e.repeats() > 1)
    if (const CullReason reason = planUnits(program, found); reason != CullReason::culled) return reason;
  const Assembly assembly = assemblyOf(shadow.real, shadow.raster().firstVertexProvokes, found.mode, e);
  const auto make = [&]() -> std::shared_ptr<CulledMesh> {
    auto mesh = CulledMesh::withoutPositions(shadow.real, content, assembly, e);
    const auto take = [&](const std::byte* positions) { mesh->takePositions(positions); };
    Elements one = e;
    one.instances = std::min(e.instances, 1);
    const bool taken =
        mesh && found.feedback->capture(shadow.real, mesh->firstVertex(), mesh->endVertex(), one, take);
    return taken ? mesh : nullptr;
  };
  // Vertex positions may change in every frame; the primitives that they form do not.
  const auto known = reinterpret_cast<uintptr_t>(&program.known());
  const Hash128 order = contentOf(shadow.real, content, found.mode, e);
  const CullReason reason = planClusters(hashBytes(&known, sizeof known, assembly.added(order)), make, found);
  // A copy of the program is linked when it is first needed.
  if (reason == CullReason::arrayState && !program.feedback().works(shadow.real))
    return CullReason::positions;
  if (reason != CullReason::culled) return reason;
  const CulledMesh& mesh = *found.mesh;
  return PositionFeedback::isPossible(mesh.firstVertex(), mesh.endVertex(), e.repeats())
             ? CullReason::culled
             : CullReason::positions;
}

bool CulledDraws::placeClusters(const Plan& plan) {
  if (!plan.feedback || placed_) return true;
  CulledMesh& mesh = *plan.mesh;
  const auto take = [&](const std::byte* positions) {
    if (!plan.units) return mesh.refit(positions);
    const size_t vertices = mesh.endVertex() - mesh.firstVertex();
    const size_t step = PositionFeedback::kStride * vertices * plan.units->size();
    mesh.refit(positions, step, plan.units->units());
  };
  placed_ = plan.feedback->capture(p_.shadow.real, mesh.firstVertex(), mesh.endVertex(), plan.elements, take);
  if (!placed_) plan.known->refused = true;
  return placed_;
}

}  // namespace gluray::gl
