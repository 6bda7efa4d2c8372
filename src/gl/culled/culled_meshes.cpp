#include "gl/culled/culled_meshes.h"

#include <algorithm>
#include <atomic>
#include <utility>

namespace gluray::gl {
namespace {

constexpr uint64_t kUnusedFrames = 8;  // a mesh that is unused for this long is forgotten
constexpr int kSteadyFrames = 3;       // frames with the same data before clusters are built

}  // namespace

CullReason CulledMeshes::find(const Hash128& name, const std::function<std::shared_ptr<CulledMesh>()>& make,
                              CullPlan& plan) {
  const bool always = shadow_.settings.cull.draws == Culling::always;
  CulledMeshHistory& known = meshes_[name];
  if (known.frames == 0 || known.lastFrame != clock_.frame) ++known.frames;
  known.lastFrame = clock_.frame;
  if (!always && known.frames < kSteadyFrames) return CullReason::unsteady;
  if (!known.mesh && !known.refused) {
    known.mesh = make();
    known.refused = !known.mesh;
  }
  if (known.refused) return CullReason::arrayState;
  if (known.different) return CullReason::notTheSame;
  prepare(known.mesh);
  if (building_ == known.mesh || !known.mesh->isBuilt()) return CullReason::smallDraw;
  known.mesh->forgetPositions();
  plan.mesh = known.mesh, plan.known = &known;
  // Few instances of a large mesh are culled by clusters.
  plan.byClusters = plan.units && plan.units->units() <= CullPlan::kFewUnits &&
                    plan.mesh->clusters().count() >= CullPlan::kLargeMesh;
  if (plan.drawsAllInstances() && !plan.byClusters) return plan.apart;
  plan.history = &historyOf(known, plan);
  return CullReason::culled;
}

/// Builds the clusters: with cull = always at once, so that the first frame is culled, else in the
/// background.
void CulledMeshes::prepare(const std::shared_ptr<CulledMesh>& mesh) {
  if (job_.busy() && job_.poll() != BackgroundJob::Outcome::none) building_.reset();
  if (building_ == mesh || mesh->isBuilt()) return;  // the job's result is not read while it runs
  if (shadow_.settings.cull.draws == Culling::always) return mesh->build();
  if (job_.busy()) return;
  building_ = mesh;
  job_.start([mesh](const std::atomic<bool>&) { mesh->build(); });
}

/// Draws of one mesh are distinguished by their arrays. Programs may make new arrays in each frame.
CullHistory& CulledMeshes::historyOf(CulledMeshHistory& known, const Hash128& arrays) {
  constexpr size_t kMax = 256;
  std::vector<CullHistory>& all = known.instanced;
  const uint64_t now = clock_.frame;
  auto found = std::ranges::find(all, arrays, &CullHistory::arrays);
  if (found == all.end()) {
    found = std::ranges::min_element(all, {}, &CullHistory::lastFrame);
    if (found == all.end() || (found->lastFrame >= now && all.size() < kMax)) found = all.emplace(all.end());
  }
  found->arrays = arrays, found->lastFrame = now;
  return *found;
}

/// The values and the number of instances may change between draws of one history.
CullHistory& CulledMeshes::historyOf(CulledMeshHistory& known, const CullPlan& plan) {
  if (!plan.units) return known.alone;
  const uint64_t form[] = {plan.elements.baseInstance};
  Hash128 arrays = hashBytes(form, sizeof form);
  for (const ArraySource& array : shadow_.attributes().generic) {
    if (array.divisor == 0) continue;
    const uint64_t identity[] = {static_cast<uint64_t>(array.location),
                                 array.buffer ? array.buffer->serial() : 0,
                                 reinterpret_cast<uintptr_t>(array.pointer)};
    arrays = hashBytes(identity, sizeof identity, arrays);
  }
  CullHistory& history = historyOf(known, arrays);
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

void CulledMeshes::forgetOld() {
  const uint64_t now = clock_.frame;
  std::erase_if(meshes_, [&](const auto& entry) {
    const CulledMeshHistory& known = entry.second;
    return (!building_ || known.mesh != building_) && known.lastFrame + kUnusedFrames < now;
  });
}

}  // namespace gluray::gl
