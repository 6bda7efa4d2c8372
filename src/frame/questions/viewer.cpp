#include "frame/questions/viewer.h"

#include <cmath>

namespace gluray::frame {

Viewer::Viewer(const scene::Snapshot& s) : viewport_(s.camera.viewport) {
  // In parallel projections rays start at the scene; eye rays do not depend on its bounds.
  rays_ = render::makeEyeRays(s, render::makeRaySetup(s, glm::vec3(-1), glm::vec3(1)));
  away_ = rays_.step;
  axes_ = render::cameraDirections(rays_, viewport_);
}

glm::dvec3 Viewer::at(double x, double y, double k) const {
  const glm::dvec4 point = rays_.start + (viewport_.x + x * viewport_.z) * rays_.startX +
                           (viewport_.y + y * viewport_.w) * rays_.startY + k * rays_.step;
  return glm::dvec3(point) / point.w;
}

glm::dvec3 Viewer::directionFrom(const glm::dvec3& point) const {
  return -glm::normalize(glm::dvec3(away_) - away_.w * point);
}

glm::dvec3 Viewer::position() const {
  return isPerspective() ? glm::dvec3(away_) / away_.w : at(0.5, 0.5, 0);
}

double Viewer::distanceOf(const glm::dvec3& point) const {
  if (isPerspective()) return glm::length(point - position());
  return glm::dot(position() - point, axes_.front);
}

double Viewer::near() const { return std::abs(glm::dot(at(0.5, 0.5, 0) - position(), axes_.front)); }
double Viewer::far() const { return std::abs(glm::dot(at(0.5, 0.5, 2) - position(), axes_.front)); }

double Viewer::angle() const {
  if (!isPerspective()) return 0;
  const glm::dvec3 eye = position(), low = glm::normalize(at(0.5, 0, 0) - eye),
                   high = glm::normalize(at(0.5, 1, 0) - eye);
  return glm::degrees(2 * std::atan2(glm::length(high - low), glm::length(high + low)));
}

double Viewer::height() const { return glm::length(at(0.5, 1, 0) - at(0.5, 0, 0)); }

glm::dvec3 worldPoint(const scene::Snapshot& s, const glm::dvec3& eye) {
  return glm::dvec3(glm::inverse(s.eyeFromWorld) * glm::dvec4(eye, 1));
}

glm::dvec3 worldDirection(const scene::Snapshot& s, const glm::dvec3& eye) {
  return glm::normalize(glm::dvec3(glm::inverse(s.eyeFromWorld) * glm::dvec4(eye, 0)));
}

CameraDescription describeCamera(const scene::Snapshot& s) {
  const Viewer viewer(s);
  const double scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(glm::inverse(s.eyeFromWorld)))));
  CameraDescription camera;
  camera.perspective = viewer.isPerspective();
  camera.angle = viewer.angle();
  camera.height = viewer.height() * scale;
  camera.position = worldPoint(s, viewer.position());
  camera.direction = worldDirection(s, -viewer.axes().front);
  camera.up = worldDirection(s, viewer.axes().up);
  camera.near = viewer.near() * scale, camera.far = viewer.far() * scale;
  return camera;
}

}  // namespace gluray::frame
