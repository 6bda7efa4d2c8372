// A thin lens: rays through the same window position leave it at different points and meet again at the
// distance in focus. Made once a frame on the calling thread, read by every tracing thread.
#pragma once
#include "scene/snapshot.h"

#include <glm/glm.hpp>

#include <memory>
#include <vector>

namespace gluray::render {

/// The ray from a point of the lens is the sheared ray from its centre. The shear maps a homogeneous point p
/// to
///   p + dot(along, p) * (x * right + y * up),
/// with (x, y) in the unit disc. `along` is 1 at the lens and 0 at the distance in focus. So the shear
/// followed by the projection is the projection as seen from that point of the lens.
struct LensShear {
  glm::dvec4 along{0};
  glm::dvec3 right{0}, up{0};  // radius of the lens, in the space of the points
  /// The same shear of the points of another space.
  LensShear in(const glm::dmat4& thisFromOther) const;
  glm::dvec4 throughLens(const glm::dvec4& p, double x, double y) const {
    return p + glm::dvec4(glm::dot(along, p) * (x * right + y * up), 0);
  }
};

/// The thin lens of R. Cook and others, "Distributed Ray Tracing", 1984: a point at distance d along the axis
/// shows as a disc with the radius of the lens times |d - f| / f, measured at d, f being the distance in
/// focus.
/// Differs: a parallel projection has no viewpoint for the lens. Distances count from the plane of the eye,
/// or from the near plane if that lies behind it; the disc is the same.
struct Lens {
  LensShear world;
  std::vector<LensShear> objects;    // one for each of Snapshot::instances
  std::vector<LensShear> lightings;  // the same in the impostors' lighting space; unused for triangles
};

/// The viewing axis, independent of the space in which the program gives the projection. With a perspective
/// projection, lengths are in units of clip-space w, which in ordinary projections is the distance from the
/// viewer, even if a program gives only the product of all its matrices. With a parallel projection, lengths
/// are in eye-space units.
class LensAxis {
 public:
  /// Throws std::runtime_error where the projection cannot be inverted.
  explicit LensAxis(const scene::Camera&);
  /// Distance from the lens, along the axis, of a point in eye space.
  double distanceOf(const glm::dvec3& eye) const;
  /// The shear in eye space of a lens with this radius that is focused at distance `focus` > 0 from it.
  LensShear shear(double radius, double focus) const;
  /// The lens radius for these settings. 0 for an f-number with a parallel projection, which has no focal
  /// length.
  double radius(const Settings::Camera&, double focus) const;
  /// Distance of the lens from the plane of the eye: not 0 only if that plane lies behind the near plane of a
  /// parallel projection.
  double start() const { return start_; }

 private:
  glm::dvec4 depth_{0};  // dot(depth_, p) is the distance from the lens
  glm::dvec3 right_{1, 0, 0}, up_{0, 1, 0};
  double start_ = 0;
  double angle_ = 0;  // tangent of half the vertical field of view; 0: parallel
  double unit_ = 1;   // length of a unit in eye space
};

/// Makes the lens of the snapshot's settings with focus distance `focus` along the axis; null unless `focus`
/// is positive. Throws std::runtime_error if a matrix cannot be inverted.
std::unique_ptr<const Lens> makeLens(const scene::Snapshot&, double focus);

}  // namespace gluray::render
