#include "gl/culled/cull_plan.h"

namespace gluray::gl {

void CullPlan::findVisible(const DepthPyramid& pyramid, std::vector<uint64_t>& visible) const {
  const Clusters& clusters = mesh->clusters();
  if (byClusters)
    findClustersOfInstances(pyramid, visible);
  else if (instances && units)
    instances->mayShow(clusters, window, &pyramid, visible);
  else if (units)
    mesh->units().mayShow(window, &pyramid, visible);
  else
    clusters.mayShow(matrix, window, &pyramid, visible);
}

void CullPlan::findClustersOfInstances(const DepthPyramid& pyramid, std::vector<uint64_t>& visible) const {
  std::vector<uint64_t> ofUnit;
  visible.clear();
  if (drawsAllInstances()) visible.resize(mesh->clusters().words(), 0);
  for (uint32_t unit = 0; unit < units->units(); ++unit) {
    const Clusters& clusters = instances ? mesh->clusters() : mesh->units().clusters(unit);
    const std::optional<ClipMatrix> place = instances ? instances->matrix(unit) : matrix;
    if (place)
      clusters.mayShow(*place, window, &pyramid, ofUnit);
    else
      clusters.all(ofUnit);
    if (drawsAllInstances())
      for (size_t i = 0; i < ofUnit.size(); ++i) visible[i] |= ofUnit[i];
    else
      visible.insert(visible.end(), ofUnit.begin(), ofUnit.end());
  }
}

uint64_t CullPlan::primitivesIn(const std::vector<uint64_t>& parts) const {
  if (!units || drawsAllInstances()) return mesh->clusters().primitivesIn(parts) * elements.repeats();
  if (!byClusters) return units->instancesIn(parts) * mesh->primitives();
  uint64_t sum = 0;
  forClustersOfInstances(parts, [&](uint32_t unit, std::span<const uint64_t> clusters) {
    sum += uint64_t{units->part(unit, unit + 1).count} * mesh->clusters().primitivesIn(clusters);
  });
  return sum;
}

}  // namespace gluray::gl
