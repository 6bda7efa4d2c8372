// Decides the fate of each draw and carries it out: the only place where draws are traced, rasterised and
// counted, for all sources of vertices. A part of each Context, GL thread.
#pragma once
#include "gl/counts/draw_counts.h"
#include "gl/draws/draw_request.h"
#include "gl/draws/raster_draws.h"

namespace gluray::gl {

/// The decision for a draw.
struct DrawPlan {
  Reason reason = Reason::traced;  // why it is not traced
  KnownMesh mesh;                  // of a traced draw
};

class Draws {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    DrawCounts& counts;
    RasterDraws& raster;
  };
  explicit Draws(const Parts& parts) : p_(parts) {}

  /// Decides the draw's fate and carries it out. Returns Fate::traced, replaced, culled or rasterised.
  Fate submit(DrawRequest& draw) { return execute(classify(draw), draw); }
  /// Carries out the fate of a draw that is rasterised for this reason.
  Fate rasterise(DrawRequest& draw, Reason reason);
  /// Prepares for a primitive that is sent to the real OpenGL vertex by vertex, and counts it, without
  /// triangles. DrawKinds::stop() ends its time.
  void beginRasterised(DrawPath path, PrimitiveClass primitive, Reason reason);

 private:
  /// Decides without drawing or changing anything.
  DrawPlan classify(DrawRequest& draw) const;
  Fate execute(const DrawPlan& plan, DrawRequest& draw);

  Parts p_;
};

}  // namespace gluray::gl
