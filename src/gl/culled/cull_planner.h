// Plans large rasterised draws: reads the state, and finds their positions, meshes and instances, before
// anything is drawn. A part of LargeDraws, GL thread, context current.
#pragma once
#include "gl/culled/cull_plan.h"
#include "gl/culled/culled_meshes.h"
#include "gl/culled/position_sources.h"
#include "gl/culled/restore_point.h"

#include <functional>
#include <memory>

namespace gluray::gl {

class CullPlanner {
 public:
  /// The arguments must outlive it.
  CullPlanner(ShadowState& shadow, const FrameClock& clock, PositionSources& sources,
              const RestorePoint& before)
      : shadow_(shadow), sources_(sources), before_(before), meshes_(shadow, clock) {}

  /// Plans a draw. Returns CullReason::culled, or the reason why the draw is not culled.
  CullReason plan(GLenum mode, const Elements& elements, CullPlan& plan);
  /// Decides whether visibility is found in a copy of the framebuffer. Returns false if it cannot be found.
  bool choosePlace(CullPlan& plan) const;

 private:
  CullReason planInstances(const PositionSource& source, CullPlan& plan);
  /// Finds the instances that can be drawn separately. Returns CullReason::culled, or the reason why nothing
  /// can be skipped.
  CullReason planUnits(const CulledProgram& program, CullPlan& plan);
  CullReason planMesh(const PositionSource& source, CullPlan& plan);
  /// Plans a draw of a shader program whose positions need transform feedback.
  CullReason planFeedback(CullPlan& plan);
  CullReason findMesh(const Hash128& name, const std::function<std::shared_ptr<CulledMesh>()>& make,
                      CullPlan& plan);

  ShadowState& shadow_;
  PositionSources& sources_;
  const RestorePoint& before_;
  CulledMeshes meshes_;
};

}  // namespace gluray::gl
