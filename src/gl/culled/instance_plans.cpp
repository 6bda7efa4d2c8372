// Draws of instances: their plans, made before anything is drawn, and how their parts are drawn.
#include "gl/culled/culled_draws.h"
#include "gl/culled/instances/instance_arrays.h"
#include "gl/culled/instances/instance_draws.h"
#include "gl/real/errors.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gluray::gl {
namespace {

constexpr uint32_t kFewUnits = 64, kLargeMesh = 256;  // clusters

}  // namespace

CullReason CulledDraws::planUnits(const CulledProgram& program, Plan& found) {
  const ArrayState& arrays = p_.shadow.attributes();
  found.apart = findUnits(p_.shadow.real, arrays, found.elements, found.units);
  if (found.apart == CullReason::deletedBuffer) return found.apart;
  if (program.numbersInstances()) found.apart = CullReason::instanceNumbers;
  // If the program reads instance numbers, each instance may have its own positions. With feedback, each
  // becomes a unit.
  if (program.numbersInstances() && found.feedback)
    found.units = InstanceUnits(found.elements.baseInstance, found.elements.repeats(), {});
  const bool large = static_cast<uint32_t>(found.elements.count) >= kLargeMesh * Clusters::kPrimitives;
  return found.drawsAllInstances() && !(large && found.units->units() <= kFewUnits) ? found.apart
                                                                                    : CullReason::culled;
}

/// A single instance is planned like a draw without instances, by clusters.
CullReason CulledDraws::planInstances(const Source& from, Plan& found) {
  const RealGl& real = p_.shadow.real;
  const ArrayState& arrays = p_.shadow.attributes();
  const Elements& e = found.elements;
  if (!from.program) return CullReason::instanced;
  if (e.repeats() > 1)
    if (const CullReason reason = planUnits(*from.program, found); reason != CullReason::culled)
      return reason;
  const InstanceUnits units = found.units ? *found.units : InstanceUnits(e.baseInstance, 1, {});
  std::vector<Instances::Column> columns;
  const Program& program = from.program->known().program;
  p_.shadow.errors.keepPending();
  const auto fractions = [&] {
    return p_.shadow.fractions.areSymmetric(real, p_.shadow.info.core).value_or(false);
  };
  const CullReason reason = instanceColumns(real, program, arrays, from.position, units, fractions, columns);
  if (reason != CullReason::culled) return reason;
  Instances instances(from.position, std::move(columns), units);
  if (found.units) return found.instances.emplace(std::move(instances)), CullReason::culled;
  const std::optional<ClipMatrix> only = instances.matrix(0);
  if (only) found.matrix = *only;
  return only ? CullReason::culled : CullReason::instanceArrays;
}

/// Whether there are few instances of a large mesh: these are culled by clusters.
bool CulledDraws::areFewAndLarge(const InstanceUnits& units, const CulledMesh& mesh) {
  return units.units() <= kFewUnits && mesh.clusters().count() >= kLargeMesh;
}

/// Draws of one mesh are distinguished by their arrays. Programs may make new arrays in each frame.
CulledDraws::History& CulledDraws::historyOf(Known& known, const Hash128& arrays) {
  constexpr size_t kMax = 256;
  std::vector<History>& all = known.instanced;
  const uint64_t now = p_.clock.frame;
  auto found = std::ranges::find(all, arrays, &History::arrays);
  if (found == all.end()) {
    found = std::ranges::min_element(all, {}, &History::lastFrame);
    if (found == all.end() || (found->lastFrame >= now && all.size() < kMax)) found = all.emplace(all.end());
  }
  found->arrays = arrays, found->lastFrame = now;
  return *found;
}

/// The values and the number of instances may change between draws of one history.
CulledDraws::History& CulledDraws::historyOf(Known& known, const Plan& plan) {
  if (!plan.units) return known.alone;
  const uint64_t form[] = {plan.elements.baseInstance};
  Hash128 arrays = hashBytes(form, sizeof form);
  for (const ArraySource& array : p_.shadow.attributes().generic) {
    if (array.divisor == 0) continue;
    const uint64_t identity[] = {static_cast<uint64_t>(array.location),
                                 array.buffer ? array.buffer->serial() : 0,
                                 reinterpret_cast<uintptr_t>(array.pointer)};
    arrays = hashBytes(identity, sizeof identity, arrays);
  }
  History& history = historyOf(known, arrays);
  if (std::exchange(history.byClusters, plan.byClusters) != plan.byClusters) history.visible.clear();
  if (history.visible.empty()) return history;
  const uint32_t units = plan.units->units();
  if (plan.byClusters) {
    history.visible.resize(plan.mesh->clusters().words() * (plan.drawsAllInstances() ? 1 : units), 0);
    return history;
  }
  history.visible.resize((units + 63) / 64, 0);
  if (units % 64) history.visible.back() &= (uint64_t{1} << units % 64) - 1;
  return history;
}

void CulledDraws::findClustersOfInstances(const Plan& plan, const DepthPyramid& pyramid,
                                          std::vector<uint64_t>& visible) {
  const CulledMesh& mesh = *plan.mesh;
  std::vector<uint64_t> ofUnit;
  visible.clear();
  if (plan.drawsAllInstances()) visible.resize(mesh.clusters().words(), 0);
  for (uint32_t unit = 0; unit < plan.units->units(); ++unit) {
    const Clusters& clusters = plan.instances ? mesh.clusters() : mesh.units().clusters(unit);
    const std::optional<ClipMatrix> matrix = plan.instances ? plan.instances->matrix(unit) : plan.matrix;
    if (matrix)
      clusters.mayShow(*matrix, plan.window, &pyramid, ofUnit);
    else
      clusters.all(ofUnit);
    if (plan.drawsAllInstances())
      for (size_t i = 0; i < ofUnit.size(); ++i) visible[i] |= ofUnit[i];
    else
      visible.insert(visible.end(), ofUnit.begin(), ofUnit.end());
  }
}

uint64_t CulledDraws::primitivesIn(const Plan& plan, const std::vector<uint64_t>& parts) {
  const CulledMesh& mesh = *plan.mesh;
  if (!plan.units || plan.drawsAllInstances())
    return mesh.clusters().primitivesIn(parts) * plan.elements.repeats();
  if (!plan.byClusters) return plan.units->instancesIn(parts) * mesh.primitives();
  uint64_t sum = 0;
  forClustersOfInstances(plan, parts, [&](uint32_t unit, std::span<const uint64_t> clusters) {
    sum += uint64_t{plan.units->part(unit, unit + 1).count} * mesh.clusters().primitivesIn(clusters);
  });
  return sum;
}

void CulledDraws::drawParts(const Plan& plan, const std::vector<uint64_t>& parts) {
  const CulledMesh& mesh = *plan.mesh;
  if (!plan.units || plan.drawsAllInstances()) return drawClusters(mesh, parts, plan.elements);
  InstanceDraws draws(p_.shadow.real, p_.shadow.attributes(), *plan.units);
  if (plan.byClusters)
    return forClustersOfInstances(plan, parts, [&](uint32_t unit, std::span<const uint64_t> clusters) {
      const bool any = std::ranges::any_of(clusters, [](uint64_t word) { return word != 0; });
      if (any)
        drawClusters(mesh, clusters, draws.elementsOf(plan.elements, plan.units->part(unit, unit + 1)));
    });
  plan.units->forParts(parts, [&](const InstancePart& part) {
    drawReal(p_.shadow.real, plan.mode, draws.elementsOf(plan.elements, part));
  });
}

}  // namespace gluray::gl
