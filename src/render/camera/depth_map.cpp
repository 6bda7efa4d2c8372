#include "render/camera/depth_map.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {

DepthMap makeDepthMap(const scene::Snapshot& snapshot) {
  const auto clamped = [](float v) { return std::clamp(static_cast<double>(v), 0.0, 1.0); };
  const double n = clamped(snapshot.camera.depthNear), f = clamped(snapshot.camera.depthFar);
  const scene::PolygonOffset& offset = snapshot.polygonOffset;
  DepthMap map;
  map.scale = 0.5 * (f - n);
  map.offset = 0.5 * (f + n);
  map.slopeFactor = offset.factor;
  map.euclidean = offset.euclidean;
  if (offset.floats)
    map.floatUnits = offset.units;
  else
    map.constant = static_cast<double>(offset.units) * offset.resolution;
  return map;
}

double DepthMap::constantOf(double ndc, double further) const {
  if (floatUnits == 0) return constant;
  const double largest = std::max(ndc * scale, further * scale) + offset;
  if (!(largest > 0)) return constant;
  return constant + floatUnits * std::ldexp(1.0, std::ilogb(static_cast<float>(largest)) - 23);
}

}  // namespace gluray::render
