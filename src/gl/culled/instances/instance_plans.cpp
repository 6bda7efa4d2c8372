// Draws of instances: what is found about them before anything is drawn, and how their parts are drawn.
#include "gl/culled/culled_draws.h"
#include "gl/culled/instances/instance_arrays.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gluray::gl {

/// A single instance is a draw of its own, whose clusters are culled.
Reason CulledDraws::planInstances(const Source& from, Plan& found) {
  const RealGl& real = p_.shadow.real;
  const ArrayState& arrays = p_.shadow.attributes;
  if (!from.program) return Reason::instanced;
  Instances::Range range;
  if (const Reason reason = instanceRange(real, arrays, found.elements, range); reason != Reason::traced)
    return reason;
  std::vector<Instances::Column> columns;
  const Program& program = from.program->known().program;
  const Reason reason = instanceColumns(real, program, arrays, from.position, range, columns);
  if (reason != Reason::traced) return reason;
  Instances instances(from.position, std::move(columns), range);
  if (range.instances > 1) return found.instances.emplace(std::move(instances)), Reason::traced;
  const std::optional<ClipMatrix> only = instances.matrix(0);
  if (only) found.matrix = *only;
  return only ? Reason::traced : Reason::instanceArrays;
}

/// Few instances of large meshes are culled by their clusters.
bool CulledDraws::areFewAndLarge(const Instances& instances, const CulledMesh& mesh) {
  constexpr uint32_t kFew = 64, kLarge = 256;
  return instances.units() <= kFew && mesh.clusters().count() >= kLarge;
}

/// Draws of one mesh are told apart by their arrays; programs may make new ones in each frame.
CulledDraws::History& CulledDraws::historyOf(Known& known, const Hash128& arrays) {
  constexpr size_t kMost = 256;
  std::vector<History>& all = known.instanced;
  const uint64_t now = p_.clock.frame;
  auto found = std::ranges::find(all, arrays, &History::arrays);
  if (found == all.end()) {
    found = std::ranges::min_element(all, {}, &History::lastFrame);
    if (found == all.end() || (found->lastFrame >= now && all.size() < kMost)) found = all.emplace(all.end());
  }
  found->arrays = arrays, found->lastFrame = now;
  return *found;
}

/// The values of instances and their number may change.
CulledDraws::History& CulledDraws::historyOf(Known& known, const Plan& plan) {
  if (!plan.instances) return known.alone;
  const uint64_t form[] = {plan.elements.baseInstance};
  Hash128 arrays = hashBytes(form, sizeof form);
  for (const ArraySource& array : p_.shadow.attributes.generic) {
    if (array.divisor == 0) continue;
    const uint64_t identity[] = {static_cast<uint64_t>(array.location),
                                 array.buffer ? array.buffer->serial() : 0,
                                 reinterpret_cast<uintptr_t>(array.pointer)};
    arrays = hashBytes(identity, sizeof identity, arrays);
  }
  History& history = historyOf(known, arrays);
  if (std::exchange(history.byClusters, plan.byClusters) != plan.byClusters) history.visible.clear();
  if (history.visible.empty()) return history;
  const uint32_t units = plan.instances->units();
  if (plan.byClusters) {
    history.visible.resize(plan.mesh->clusters().words() * units, 0);
    return history;
  }
  history.visible.resize((units + 63) / 64, 0);
  if (units % 64) history.visible.back() &= (uint64_t{1} << units % 64) - 1;
  return history;
}

void CulledDraws::findClustersOfInstances(const Plan& plan, const DepthPyramid& pyramid,
                                          std::vector<uint64_t>& visible) {
  const Clusters& clusters = plan.mesh->clusters();
  std::vector<uint64_t> ofUnit;
  visible.clear();
  for (uint32_t unit = 0; unit < plan.instances->units(); ++unit) {
    if (const std::optional<ClipMatrix> matrix = plan.instances->matrix(unit))
      clusters.mayShow(*matrix, plan.window, &pyramid, ofUnit);
    else
      clusters.all(ofUnit);
    visible.insert(visible.end(), ofUnit.begin(), ofUnit.end());
  }
}

uint64_t CulledDraws::primitivesIn(const Plan& plan, const std::vector<uint64_t>& parts) {
  const CulledMesh& mesh = *plan.mesh;
  if (!plan.instances) return mesh.clusters().primitivesIn(parts);
  if (!plan.byClusters) return plan.instances->instancesIn(parts) * mesh.primitives();
  uint64_t sum = 0;
  forClustersOfInstances(plan, parts, [&](uint32_t unit, std::span<const uint64_t> clusters) {
    const auto instances =
        static_cast<uint64_t>(plan.instances->part(plan.elements, unit, unit + 1).instances);
    sum += instances * mesh.clusters().primitivesIn(clusters);
  });
  return sum;
}

void CulledDraws::drawParts(const Plan& plan, const std::vector<uint64_t>& parts) {
  const CulledMesh& mesh = *plan.mesh;
  if (!plan.instances) return drawClusters(mesh, parts, plan.elements);
  if (plan.byClusters)
    return forClustersOfInstances(plan, parts, [&](uint32_t unit, std::span<const uint64_t> clusters) {
      drawClusters(mesh, clusters, plan.instances->part(plan.elements, unit, unit + 1));
    });
  plan.instances->forRuns(parts, [&](uint32_t first, uint32_t end) {
    drawReal(p_.shadow.real, plan.mode, plan.instances->part(plan.elements, first, end));
  });
}

}  // namespace gluray::gl
