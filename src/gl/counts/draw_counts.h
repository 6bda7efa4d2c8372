// Counts draws for `--report` and `gluray explain`, and for EngineChoice. A part of each Context, GL thread.
#pragma once
#include "gl/basics/reasons.h"
#include "gl/basics/statistics.h"
#include "gl/clock/frame_clock.h"
#include "gl/counts/decisions.h"
#include "gl/counts/draw_kinds.h"
#include "gl/shadow/shadow_state.h"

#include <cstdint>

namespace gluray::gl {

class DrawCounts {
 public:
  DrawCounts(ShadowState& shadow, FrameClock& clock) : shadow_(shadow), clock_(clock) {}

  Statistics statistics;
  /// Records draws by kind; null unless `gluray explain` runs.
  DrawKinds* kinds() const { return shadow_.info.kinds.get(); }

  /// Logs decisions; null if no log is requested. Null if kinds() is null.
  Decisions* decisions() const { return shadow_.info.decisions.get(); }

  void rasterised(Reason reason, DrawPath path, PrimitiveClass kind, uint64_t triangles) {
    if (kinds()) [[unlikely]]
      explain(reason, path, kind, triangles);
    ++statistics.drawsRasterised;
    ++statistics.rasterisedBecause[static_cast<size_t>(reason)];
    statistics.trianglesRasterised += triangles;
    load(triangles);
  }
  void traced(DrawPath path, uint64_t triangles) { traced(path, triangles, triangles); }
  /// The same for impostors, which are counted individually. `sent`: triangles that would be drawn without
  /// tracing.
  void traced(DrawPath path, uint64_t triangles, uint64_t sent);
  /// Reports that the draw last counted by rasterised() was culled. `leftOut`: number of its triangles that
  /// were skipped because they are invisible.
  void culled(uint64_t leftOut);
  /// Reason why this draw was not culled. Set only for draws above the size threshold.
  void notCulled(CullReason reason);
  /// Result for a rasterised draw: LightReason::lit, or the reason why it was not lit.
  void lit(LightReason reason);
  /// Moves the snapshot's instances from traced to rasterised: the real OpenGL drew them after all.
  void asRasterised(const scene::Snapshot& snapshot, Reason reason);
  /// Adds to the frame's load. Called by rasterised() and traced(), and at the end of a primitive that was
  /// given to the real OpenGL.
  void load(uint64_t triangles) { clock_.choice.drew(triangles, shadow_.viewportPixels()); }
  /// Increases with everything drawn that may be cached: images, and meshes that were never traced.
  uint64_t work() const { return statistics.flushes + statistics.meshesBuilt; }

 private:
  void explain(Reason reason, DrawPath path, PrimitiveClass kind, uint64_t triangles);

  ShadowState& shadow_;
  FrameClock& clock_;
};

}  // namespace gluray::gl
