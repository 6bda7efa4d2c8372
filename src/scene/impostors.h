// Parameters of impostors: spheres, discs and cylinders that a fragment program draws on flat billboards, and
// points and lines with a width in pixels that it shades as round. Geometry is in scene/mesh.h; centres,
// radii and axes act in the space of Instance::lightingFromObject.
#pragma once
#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace gluray::scene {

/// The viewer is at the origin, or at infinity along +z. Programs compute one point per pixel, at its centre,
/// where the billboard is visible.
struct Impostors {
  /// The billboard's shape. silhouette: covers the whole impostor. triangle: circumscribes the circle of the
  /// impostor's radius in the plane through its centre that faces the viewer, one corner upwards. faces: two
  /// faces of the box about a cylinder, the side towards the viewer and the end that `axis` points to.
  /// square: of spheres, in the plane of constant z through the centre; for a viewer at the origin wider than
  /// the sphere, by about as much as its silhouette is (accel/impostors/placed_impostors.cpp).
  enum class Billboards : uint8_t { silhouette, triangle, faces, square };
  Billboards billboards = Billboards::silhouette;
  bool parallelView = false;  // the viewer is at infinity
  bool inside = false;        // spheres show their far side, from within
  /// Of spheres with squares: discs of constant z with normals and depths of the half sphere above them, as
  /// if every sphere were seen along -z. A point of the disc at the share q of the radius from the centre has
  /// the normal (x, y, sqrt(1 - q^2)) and the depth of the eye z that is radius * sqrt(1 - q^2) nearer. What
  /// reaches through the near plane does not exist. Lenses and secondary rays see whole spheres.
  bool hemispheres = false;
  bool fades = false;  // discs and splats: multiply colours by 1 - (distance from the centre / radius)^2
  // Discs and splats: multiply opacities by exp(-(distance from the centre / radius)^2 / 2), and cover their
  // billboards.
  bool gaussian = false;
  // Splats: multiply colours by 1 - distance from the centre / radius, cover their billboards, and have
  // antialiased edges: where s = distance / radius - 1 is positive, opacities are 1 - smoothstep(0, w, s) for
  // the sum w of |s| of the differences between two pixels of a 2x2 block in its row, and in its column.
  bool antialiased = false;
  // Of these, if it is not 0: only their outline, so many w wide. Opacities are 1 - smoothstep((outline/2 -
  // 1) w, (outline/2 + 1) w, |s|), and colours stay as they are.
  float outline = 0;
  /// Whether they cover their billboards, and opacities fall off.
  bool fillsBillboard() const { return gaussian || antialiased; }
  float radiusDivisor = 1;  // radius of the billboard / radius of the disc
  /// A cylinder's axis in lighting space is axisMatrix * axis, reversed if it points to -z; its length is
  /// that of `axis`. Only the end that it points to is closed.
  glm::mat3 axisMatrix{1};
  /// Clip planes, object space: an impostor whose centre is on the negative side of one does not exist. They
  /// cut a tube's line instead, and with each of its points the tube's whole cross-section.
  std::vector<glm::vec4> centerPlanes;

  // A splat is the image of a ball of its radius, in object space, under lightingFromObject and the affine
  // approximation of the projection at its centre ("EWA Splatting", Zwicker et al. 2002, equation 29):
  //   C = J W W^T J^T + L, J = [s.x/z, 0, -s.x x/z^2; 0, s.y/z, -s.y y/z^2] (of a viewer at infinity [s.x, 0,
  //   0; 0, s.y, 0])
  // with s = `size` and L = `lowpass` (xx, xy, yy); off-diagonal entries of at most 1e-6 count as 0. It
  // covers positions p in normalised device coordinates, relative to the centre, with p^T C^-1 p <= 1, all at
  // the centre's depth plus `depthBias`. A splat whose centre is more than 1.3 from the middle of the window
  // does not exist. Those that fill them cover their billboards, the squares |q.x|, |q.y| <= `billboardScale`
  // with p = (sqrt(a) A, sqrt(b) B) q for the eigenvalues a >= b of C and their eigenvectors A and B; without
  // off-diagonal entries (A, B) = 1.
  float billboardScale = 1;
  glm::vec3 lowpass{0};

  // Beads and tubes are flat billboards of a fixed size in the window, lit as if they were round
  // (accel/impostors/pixel_impostor.h). Size in normalised device coordinates (of splats: see above): width
  // and height of beads; width of tubes along y, and of tubes along x.
  glm::vec2 size{0};
  // Programs compute a bead's look so many pixels beside the pixel's centre: some implementations of OpenGL
  // do so with multisampling.
  glm::vec2 coordinateShift{0};
  // Tubes shorter than wide grow by a quarter of the difference at each end.
  bool grows = false;
  // Tubes' sides are offset along the line's normal in pixels instead of normalised device coordinates, and
  // their second end reaches `longer` pixels further. Lines that are points in the window run to the right.
  bool inPixels = false;
  float longer = 0;
  // With b = bulge * (1 in the middle, 0 at the sides), window depth z becomes z + b * bulgeDepth for a
  // viewer at infinity, otherwise bulgeDepth + (z - bulgeDepth) / (1 - b). `depthBias` is then added, and the
  // result clamped to [0, 1].
  float bulge = 0, bulgeDepth = 0, depthBias = 0;

  // Balls and capsules, round in lighting space. Their radius there; 0: half of `size` at each vertex's
  // distance from the viewer. They exist where no `centerPlanes` cut their points and lines away.
  float radius = 0;
  bool unlit = false;  // the program draws them without lighting: GLuRay's own light shades them

  // Sticks: whether ends that are marked as round are, and how the colours of two halves change: smoothly
  // around the middle, over twice the share clamp(-halvesBlend * z, 0, 0.5) of the length, by the z of the
  // point where the line of sight enters the cylinder.
  bool roundEnds = true;
  float halvesBlend = 0;
  bool operator==(const Impostors&) const = default;
};

/// An impostor's centre in lighting space, computed in the programs' order and precision.
inline glm::vec3 impostorCenter(const glm::mat4& lightingFromObject, const glm::vec3& p) {
  const glm::mat4& m = lightingFromObject;
  return {m[0].x * p.x + m[1].x * p.y + m[2].x * p.z + m[3].x,
          m[0].y * p.x + m[1].y * p.y + m[2].y * p.z + m[3].y,
          m[0].z * p.x + m[1].z * p.y + m[2].z * p.z + m[3].z};
}

}  // namespace gluray::scene
