// Impostors as the solids that they stand for, met by rays from anywhere: shadows, occlusion and reflections
// see them so. Rays from the viewer see what programs draw instead (impostors.h, pixel_impostor.h). Any
// thread.
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
///   bead      the sphere as wide as the point is in the window
///   tube      the cone between two such spheres about the line's ends, and the spheres
///   ball, capsule  themselves
///   stick     itself; open ends are closed
///   splat     the ball that the program flattens into an ellipse
/// Nothing where the ray misses it or the instance's planes cut it away. Computed in double precision: radii
/// and distances may differ by any factor.
std::optional<SolidHit> meetSolid(const PlacedImpostors&, uint32_t primitive, const ObjectRay&);

}  // namespace gluray::accel
