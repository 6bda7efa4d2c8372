// Points of surfaces whose light is asked for, as rows of one value for each lane. Filled by kernels, read by
// integrators. Any thread.
#pragma once
#include "render/local/group.h"

#include <cstdint>

namespace gluray::render {

/// Points of a packet. Both normals are of unit length, in eye space, on the viewer's side.
struct SurfacePoints {
  alignas(
      64) Row origin[3];   // world space: above the point by its error, so that rays do not meet its surface
  alignas(64) Row eye[3];  // the same point in eye space
  alignas(64) Row lift;    // how far the curved surface is above the triangle; 0: less than rounding
  alignas(64) Row geometric[3];  // of the triangle
  alignas(64) Row shading[3];    // of the surface that the triangles stand for
};

/// Points that take samples of light, of one packet of pixels or of several.
struct AskedPoints {
  uint32_t lanes = 0;  // bit i: lane i counts
  int sample = 0;      // of those that the pixels take
  SurfacePoints points;
  alignas(64) Row x, y;                     // window positions
  alignas(64) uint32_t instance[kLanes];    // that the points are on
  alignas(64) uint32_t place[kLanes] = {};  // of the pixel among those of its 4x4 block: its lane there
};

}  // namespace gluray::render
