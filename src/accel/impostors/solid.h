// Impostors as solids, for secondary rays: shadows, occlusion and reflections. Primary rays hit what programs
// draw instead (impostors.h, pixel_impostor.h). Any thread.
#pragma once
#include "accel/impostors/placed_impostors.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>

namespace gluray::accel {

/// A ray org + t*dir, t in [tNear, tFar], object space.
struct ObjectRay {
  glm::vec3 org, dir;
  float tNear, tFar;
};

struct SolidHit {
  float t;
  glm::vec3 normal;  // outwards, object space, not of unit length
};

/// The nearest hit of an impostor:
///   sphere    its sphere, if the program shows it
///   disc      the disc that faces the viewer, from both sides
///   cylinder  with both of its ends
///   bead      the sphere with the point's width in the window
///   tube      the convex hull of two such spheres at the line's ends
///   ball, capsule  themselves
///   stick     itself; open ends are closed
///   splat     the ball that the program flattens into an ellipse
/// Beads and tubes are met from outside only: their points are where pixels show them, which may be inside of
/// the next segment of a line by less than a pixel.
/// None if the ray misses it or the instance's clip planes cut it away. Computed in double precision: radii
/// and distances may differ by any factor.
std::optional<SolidHit> meetSolid(const PlacedImpostors&, uint32_t primitive, const ObjectRay&);

}  // namespace gluray::accel
