// The meshes of large rasterised draws, known by the content of the draws: their clusters and histories. A
// part of LargeDraws, GL thread.
#pragma once
#include "base/background_job.h"
#include "gl/clock/frame_clock.h"
#include "gl/culled/cull_plan.h"
#include "gl/shadow/shadow_state.h"

#include <functional>
#include <memory>
#include <unordered_map>

namespace gluray::gl {

class CulledMeshes {
 public:
  CulledMeshes(ShadowState& shadow, const FrameClock& clock) : shadow_(shadow), clock_(clock) {}
  ~CulledMeshes() { job_.stop(); }
  CulledMeshes(const CulledMeshes&) = delete;
  CulledMeshes& operator=(const CulledMeshes&) = delete;

  bool contains(const Hash128& name) const { return meshes_.contains(name); }
  /// Completes the plan of a draw whose content has this name. `make` returns the mesh, or null if it cannot
  /// be read; called when frames have drawn it often enough. Returns CullReason::culled, or the reason why
  /// the draw is not culled now.
  CullReason find(const Hash128& name, const std::function<std::shared_ptr<CulledMesh>()>& make,
                  CullPlan& plan);
  /// Forgets meshes that have not been drawn for long.
  void forgetOld();

 private:
  void prepare(const std::shared_ptr<CulledMesh>& mesh);
  CullHistory& historyOf(CulledMeshHistory& known, const CullPlan& plan);
  CullHistory& historyOf(CulledMeshHistory& known, const Hash128& arrays);

  ShadowState& shadow_;
  const FrameClock& clock_;
  std::unordered_map<Hash128, CulledMeshHistory> meshes_;
  BackgroundJob job_;
  std::shared_ptr<CulledMesh> building_;
};

}  // namespace gluray::gl
