// Maps NDC depths to window depths. Made once a frame, read by every tracing thread.
#pragma once
#include "scene/snapshot.h"

namespace gluray::render {

/// Maps NDC depth to window depth, including glDepthRange and glPolygonOffset.
struct DepthMap {
  double scale = 0.5, offset = 0.5;  // window = scale * ndc + offset
  double slopeFactor = 0,
         constant = 0;     // polygon offset: slopeFactor * steepest window-space slope + constant
  bool euclidean = false;  // the slope is the length of the gradient instead
  double floatUnits = 0;   // also added: so many units in the last place of a triangle's largest float depth
  /// Window depth, not clamped, without the triangle's own part of the polygon offset.
  double windowDepth(double ndc) const { return ndc * scale + offset + constant; }
  /// The constant part of the polygon offset of a triangle whose NDC depths range from `ndc` to `further`.
  double constantOf(double ndc, double further) const;
};

DepthMap makeDepthMap(const scene::Snapshot&);

}  // namespace gluray::render
