#include "gl/culled/cull_planner.h"

#include "gl/culled/cullable_state.h"
#include "gl/culled/draw_content.h"
#include "gl/culled/drawn_region.h"
#include "gl/culled/instances/instance_arrays.h"
#include "gl/culled/instances/instance_draws.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"

#include <algorithm>
#include <utility>
#include <vector>

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

CullReason CullPlanner::plan(GLenum mode, const Elements& e, CullPlan& found) {
  found.mode = mode, found.elements = e;
  if (const CullReason reason = cullableState(shadow_, mode); reason != CullReason::culled) return reason;
  const DrawnRegion region = drawnRegionOf(shadow_);
  found.region = region.drawn, found.samples = region.samples, found.reversed = region.reversed;
  found.window = mappingTo(found.region, shadow_);
  if (found.region.width <= 0 || found.region.height <= 0) return CullReason::smallDraw;
  if (!choosePlace(found)) return CullReason::samplesInUse;
  PositionSource from;
  const CullReason reason = sources_.find(mode, e, from);
  if (reason == CullReason::positions && shadow_.raster().program != 0) return planFeedback(found);
  if (reason != CullReason::culled) return reason;
  if (found.samples > 1 && from.program && from.program->usesCentroids()) return CullReason::multisampleState;
  found.program = from.program, found.matrix = from.matrix;
  if (e.repeats() > 1 || e.baseInstance != 0 || !from.position.terms.empty())
    if (const CullReason why = planInstances(from, found); why != CullReason::culled) return why;
  return planMesh(from, found);
}

bool CullPlanner::choosePlace(CullPlan& plan) const {
  plan.rehearsed = plan.samples > 1 && !before_.isClear(plan.region);
  // A copy of a window may have its samples at other places in the pixels.
  return !plan.rehearsed || shadow_.target().framebuffer != 0;
}

CullReason CullPlanner::findMesh(const Hash128& name,
                                 const std::function<std::shared_ptr<CulledMesh>()>& make, CullPlan& found) {
  if (!meshes_.contains(name)) meshes_.forgetOld(), sources_.forgetOld();
  return meshes_.find(name, make, found);
}

CullReason CullPlanner::planMesh(const PositionSource& from, CullPlan& found) {
  const Elements& e = found.elements;
  DrawContent content;
  const CullReason reason =
      readContent(shadow_, *from.arrays, *from.positions, from.components, found.mode, e, content);
  if (reason != CullReason::culled) return reason;
  const auto make = [&] {
    return CulledMesh::create(shadow_.real, *from.positions, from.components, content.arrays,
                              content.assembly, e);
  };
  return findMesh(content.name, make, found);
}

CullReason CullPlanner::planFeedback(CullPlan& found) {
  const Elements& e = found.elements;
  CulledProgram& program = sources_.programInUse();
  if (found.samples > 1 && program.usesCentroids()) return CullReason::multisampleState;
  if (isOn(shadow_.real, GL_BLEND))
    if (const CullReason reason = sources_.blendingOf(program, {}, found.mode, e);
        reason != CullReason::culled)
      return reason;
  const ArrayState& arrays = shadow_.attributes();
  if (arrays.reason == Reason::deletedBuffer) return CullReason::deletedBuffer;
  if (!areAllInBuffers(arrays) || !areAllInBuffers(shadow_.arrays()) || (e.type && !arrays.elements))
    return CullReason::arrayState;
  ArrayState content;
  content.elements = arrays.elements;
  if (e.type && foreignReason(content) != Reason::traced) return CullReason::foreignBuffer;
  shadow_.errors.keepPending();
  found.program = &program, found.feedback = &program.feedback();
  if (e.repeats() > 1)
    if (const CullReason reason = planUnits(program, found); reason != CullReason::culled) return reason;
  const Assembly assembly = assemblyOf(shadow_.real, shadow_.raster().firstVertexProvokes, found.mode, e);
  const auto make = [&]() -> std::shared_ptr<CulledMesh> {
    auto mesh = CulledMesh::withoutPositions(shadow_.real, content, assembly, e);
    const auto take = [&](const std::byte* positions) { mesh->takePositions(positions); };
    Elements one = e;
    one.instances = std::min(e.instances, 1);
    const bool taken =
        mesh && found.feedback->capture(shadow_.real, mesh->firstVertex(), mesh->endVertex(), one, take);
    return taken ? mesh : nullptr;
  };
  // Vertex positions may change in every frame; the primitives that they form do not.
  const auto known = reinterpret_cast<uintptr_t>(&program.known());
  const Hash128 order = contentOf(shadow_.real, content, found.mode, e);
  const CullReason reason = findMesh(hashBytes(&known, sizeof known, assembly.added(order)), make, found);
  // A copy of the program is linked when it is first needed.
  if (reason == CullReason::arrayState && !program.feedback().works(shadow_.real))
    return CullReason::positions;
  if (reason != CullReason::culled) return reason;
  const CulledMesh& mesh = *found.mesh;
  return PositionFeedback::isPossible(mesh.firstVertex(), mesh.endVertex(), e.repeats())
             ? CullReason::culled
             : CullReason::positions;
}

CullReason CullPlanner::planUnits(const CulledProgram& program, CullPlan& found) {
  const ArrayState& arrays = shadow_.attributes();
  found.apart = findUnits(shadow_.real, arrays, found.elements, found.units);
  if (found.apart == CullReason::deletedBuffer) return found.apart;
  if (program.numbersInstances()) found.apart = CullReason::instanceNumbers;
  // If the program reads instance numbers, each instance may have its own positions. With feedback, each
  // becomes a unit.
  if (program.numbersInstances() && found.feedback)
    found.units = InstanceUnits(found.elements.baseInstance, found.elements.repeats(), {});
  const bool large =
      static_cast<uint32_t>(found.elements.count) >= CullPlan::kLargeMesh * Clusters::kPrimitives;
  const bool byClusters = large && found.units->units() <= CullPlan::kFewUnits;
  return found.drawsAllInstances() && !byClusters ? found.apart : CullReason::culled;
}

/// A single instance is planned like a draw without instances, by clusters.
CullReason CullPlanner::planInstances(const PositionSource& from, CullPlan& found) {
  const RealGl& real = shadow_.real;
  const ArrayState& arrays = shadow_.attributes();
  const Elements& e = found.elements;
  if (!from.program) return CullReason::instanced;
  if (e.repeats() > 1)
    if (const CullReason reason = planUnits(*from.program, found); reason != CullReason::culled)
      return reason;
  const InstanceUnits units = found.units ? *found.units : InstanceUnits(e.baseInstance, 1, {});
  std::vector<Instances::Column> columns;
  const Program& program = from.program->known().program;
  shadow_.errors.keepPending();
  const auto fractions = [&] {
    return shadow_.fractions.areSymmetric(real, shadow_.info.core).value_or(false);
  };
  const CullReason reason = instanceColumns(real, program, arrays, from.position, units, fractions, columns);
  if (reason != CullReason::culled) return reason;
  Instances instances(from.position, std::move(columns), units);
  if (found.units) return found.instances.emplace(std::move(instances)), CullReason::culled;
  const std::optional<ClipMatrix> only = instances.matrix(0);
  if (only) found.matrix = *only;
  return only ? CullReason::culled : CullReason::instanceArrays;
}

}  // namespace gluray::gl
