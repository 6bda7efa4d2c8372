// Culls large rasterised draws: draws only the clusters or instances that may be visible (adr/0064,
// adr/0066). A part of CulledDraws, GL thread.
#pragma once
#include "gl/counts/draw_counts.h"
#include "gl/culled/cull_planner.h"
#include "gl/culled/part_draws.h"
#include "gl/culled/restore_point.h"
#include "gl/trials/trial_budget.h"

#include <GL/gl.h>

#include <cstdint>
#include <functional>
#include <vector>

namespace gluray::gl {

class LargeDraws {
 public:
  struct Parts {
    ShadowState& shadow;
    FrameClock& clock;
    DrawCounts& counts;
    PendingBatch& pending;
    const RasterDraws& raster;
    PositionSources& sources;
  };
  explicit LargeDraws(const Parts& parts)
      : p_(parts),
        before_(parts.shadow, parts.pending, parts.raster),
        planner_(parts.shadow, parts.clock, parts.sources, before_),
        parts_(parts.shadow, parts.pending) {}

  /// As CulledDraws::draw(), for a large draw. May throw.
  bool draw(GLenum mode, const Elements& elements, const std::function<void()>& first);

 private:
  /// Draws culled or whole, whichever was faster.
  void drawTried(const CullPlan& plan);
  /// Returns false if nothing was drawn, because the visible parts are not known yet, or the framebuffer
  /// cannot be copied.
  bool drawCulled(const CullPlan& plan);
  /// Like drawCulled(), with visibility found in a copy of the framebuffer. If `verified`, compares the
  /// results of this and of the whole draw in copies, and makes the whole draw if they differ.
  bool drawRehearsed(const CullPlan& plan, bool verified);
  bool rehearse(const CullPlan& plan, std::vector<uint64_t>& visible);
  void drawVerified(const CullPlan& plan);
  bool isSame(const CullPlan& plan, const std::vector<uint64_t>& visible);
  /// Records that a culled draw differed from the whole draw.
  void markDifferent(const CullPlan& plan);
  /// Counts the primitives that were skipped; `drawn`: number of drawn primitives.
  void countLeft(const CullPlan& plan, uint64_t drawn);
  /// All pixels of the region, for comparison.
  struct Pixels {
    std::vector<float> depths;
    std::vector<uint32_t> colors;  // multisampled: colours and depths of all samples
    bool operator==(const Pixels&) const = default;
  };
  bool read(const CullPlan& plan, Pixels& pixels);

  Parts p_;
  TrialBudget trials_;
  RestorePoint before_;
  CullPlanner planner_;
  PartDraws parts_;
};

}  // namespace gluray::gl
