// Camera parameters of a snapshot for users: position, axes, field of view. Any thread.
#pragma once
#include "render/lights/rig.h"
#include "scene/snapshot.h"

#include <glm/glm.hpp>

namespace gluray::frame {

/// The viewer of a snapshot with any projection. Eye space.
class Viewer {
 public:
  /// Throws std::runtime_error if a matrix cannot be inverted.
  explicit Viewer(const scene::Snapshot&);
  /// Right and up in the window, front towards the viewer.
  const render::Directions& axes() const { return axes_; }
  bool isPerspective() const { return away_.w != 0; }
  /// The direction away from the viewer at point p is away().xyz - away().w * p.
  const glm::dvec4& away() const { return away_; }
  /// Unit length, from a point to the viewer.
  glm::dvec3 directionFrom(const glm::dvec3& point) const;
  /// Of a point from the viewer; in parallel projections from the near plane.
  double distanceOf(const glm::dvec3& point) const;
  /// The viewpoint; in parallel projections the centre of the near plane.
  glm::dvec3 position() const;
  double near() const, far() const;  // distances from position() along the axis
  /// Vertical field of view in degrees; 0 in parallel projections.
  double angle() const;
  /// Height of the view volume at distance near().
  double height() const;

 private:
  glm::dvec3 at(double x, double y, double k) const;

  render::RaySetup rays_;
  glm::ivec4 viewport_;
  glm::dvec4 away_;
  render::Directions axes_;
};

/// A view's camera, in world space.
struct CameraDescription {
  bool perspective = true;
  double angle = 0, height = 0;  // degrees of perspectives; height of parallel projections
  glm::dvec3 position{0}, direction{0, 0, -1}, up{0, 1, 0};
  double near = 0, far = 0;
};
CameraDescription describeCamera(const scene::Snapshot&);

/// Transforms a direction from eye space to a unit vector in world space.
glm::dvec3 worldDirection(const scene::Snapshot&, const glm::dvec3& eye);
glm::dvec3 worldPoint(const scene::Snapshot&, const glm::dvec3& eye);

}  // namespace gluray::frame
