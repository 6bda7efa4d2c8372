// Round impostors that a fragment program cuts out of flat billboards ("impostors"): what of a sphere, disc
// or cylinder is seen, and points and lines of so many pixels that are shown as if they were round. Geometry
// is in scene/mesh.h; centres, radii and axes act in the space of Instance::lightingFromObject.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::scene {

/// The viewer is at the origin, or at infinity along +z. Programs compute one point a pixel, at its centre,
/// and only where a billboard of theirs is seen.
struct Impostors {
  /// Which billboard that is. silhouette: one that hides nothing of the impostor. triangle: the triangle
  /// about the circle of the impostor's radius in the plane through its centre that faces the viewer, one
  /// corner upwards. faces: of the box about a cylinder, the side that faces the viewer and the end that
  /// `axis` points to.
  enum class Billboards : uint8_t { silhouette, triangle, faces };
  Billboards billboards = Billboards::silhouette;
  bool parallelView = false;  // the viewer is at infinity
  bool inside = false;        // of spheres the far side is seen, from within
  bool fades =
      false;  // of discs and splats: colours are multiplied by 1 - (distance from the centre / radius)^2
  float radiusDivisor = 1;  // discs are this much smaller than their billboards
  /// Cylinders' axes in the lighting space: axisMatrix * axis, turned to +z; their length is that of the axis
  /// before. They are closed at the end that this points to alone.
  glm::mat3 axisMatrix{1};
  /// Object space; impostors whose centre is on the negative side of one of them are not there.
  /// Of tubes, the planes cut the line instead, and with each of its points all that is across it.
  std::vector<glm::vec4> centerPlanes;

  // A splat is what becomes of a ball of its radius, in object space, by lightingFromObject and an affine
  // approximation of the projection about its centre ("EWA Splatting", Zwicker et al. 2002, equation 29):
  //   C = J W W^T J^T, J = [s.x/z, 0, -s.x x/z^2; 0, s.y/z, -s.y y/z^2] (of a viewer at infinity [s.x, 0, 0;
  //   0, s.y, 0])
  // with s = `size`; entries beside the diagonal of at most 1e-6 count as 0. Positions p in normalised device
  // coordinates, from the centre's, with p^T C^-1 p <= 1 are covered, all at the centre's depth and
  // `depthBias`. Those whose centre is more than 1.3 away from the middle of the window are not there.

  // Beads and tubes are flat billboards of a fixed size in the window, lit as if they were round
  // (accel/impostors/pixel_impostor.h).
  // Size in normalised device coordinates (of splats: see above): beads' both ways; tubes' width where they
  // run along y, and along x.
  glm::vec2 size{0};
  // Tubes shorter than they are wide grow by a quarter of the difference at each end.
  bool grows = false;
  // With b = bulge * (1 in the middle, 0 at the sides), their window depth z becomes z + b * bulgeDepth where
  // the viewer is at infinity, otherwise bulgeDepth + (z - bulgeDepth) / (1 - b); and then, moved by
  // `depthBias`, it is cut to [0, 1].
  float bulge = 0, bulgeDepth = 0, depthBias = 0;
  bool operator==(const Impostors&) const = default;
};

/// An impostor's centre in lighting space, in the order and precision that programs compute it in.
inline glm::vec3 impostorCenter(const glm::mat4& lightingFromObject, const glm::vec3& p) {
  const glm::mat4& m = lightingFromObject;
  return {m[0].x * p.x + m[1].x * p.y + m[2].x * p.z + m[3].x,
          m[0].y * p.x + m[1].y * p.y + m[2].y * p.z + m[3].y,
          m[0].z * p.x + m[1].z * p.y + m[2].z * p.z + m[3].z};
}

}  // namespace gluray::scene
