// Surface points for light computation, as rows of one value for each lane. Written by kernels, read by
// integrators. Any thread.
#pragma once
#include "render/local/group.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace gluray::render {

/// Points of a packet. Both normals are of unit length, in eye space, on the viewer's side.
struct SurfacePoints {
  /// World space: offset above the point by its error, so that rays do not hit the surface of the point.
  alignas(64) Row origin[3];
  alignas(64) Row eye[3];        // the same point in eye space
  alignas(64) Row lift;          // height of the curved surface above the triangle; 0: below rounding
  alignas(64) Row geometric[3];  // of the triangle
  alignas(64) Row shading[3];    // of the curved surface that the triangles approximate
  // 1 where fixed function lights the surface by a normal on the other side, as programs do whose normals
  // point inwards; otherwise 0.
  alignas(64) Row turned;
};

/// Points to estimate light at, from one or several packets of pixels.
/// The part of `samples` light samples that hits with such a share of a pixel take: at least one.
inline int partOf(int samples, float share) {
  constexpr float kRounding = 1e-3f;
  return std::max(1, static_cast<int>(std::ceil(static_cast<float>(samples) * share - kRounding)));
}

struct AskedPoints {
  uint32_t lanes = 0;  // bit i: lane i counts
  int sample = 0;      // of those that the pixels take
  float share = 1;     // as ColoredHits::share
  SurfacePoints points;
  alignas(64) Row x, y;                     // window positions
  alignas(64) uint32_t instance[kLanes];    // of the points
  alignas(64) uint32_t place[kLanes] = {};  // of the pixel among those of its 4x4 block: its lane there
};

}  // namespace gluray::render
