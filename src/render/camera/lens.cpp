#include "render/camera/lens.h"

#include "scene/failure.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

glm::dmat4 inverseOf(const glm::dmat4& m, const char* what) {
  const glm::dmat4 inverse = glm::inverse(m);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(inverse[c][r])) throw scene::Untraceable(std::string(what) + " cannot be inverted");
  return inverse;
}

glm::dvec3 unit(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : v;
}

/// Whether the view volume is a frustum, beyond the rounding of matrices that programs multiply in float.
bool isPerspective(const glm::dmat4& eyeFromClip) {
  const double change = std::abs(eyeFromClip[0].w) + std::abs(eyeFromClip[1].w) + std::abs(eyeFromClip[2].w);
  return change > 0x1p-22 * std::abs(eyeFromClip[3].w);
}

/// The direction from one homogeneous point to another.
glm::dvec3 direction(const glm::dvec4& from, const glm::dvec4& to) {
  return unit(glm::dvec3(to) * from.w - glm::dvec3(from) * to.w);
}

}  // namespace

LensShear LensShear::in(const glm::dmat4& thisFromOther) const {
  const glm::dmat3 otherFromThis = glm::inverse(glm::dmat3(thisFromOther));
  return {along * thisFromOther, otherFromThis * right, otherFromThis * up};
}

LensAxis::LensAxis(const scene::Camera& camera) {
  const glm::dmat4 eyeFromClip = inverseOf(camera.clipFromEye, "the projection matrix");
  const glm::dvec4 w = glm::transpose(camera.clipFromEye)[3];
  // Reversed projections map the near plane to 1.
  const double nearest = camera.largestWins ? camera.firstNdcDepth() : -1.0;
  const glm::dvec4 middle[] = {eyeFromClip * glm::dvec4(0, 0, nearest, 1),
                               eyeFromClip * glm::dvec4(0, 0, -nearest, 1)};
  glm::dvec3 axis;
  const bool perspective = isPerspective(eyeFromClip);
  if (perspective) {
    const double perUnit = glm::length(glm::dvec3(w));
    depth_ = w;
    unit_ = 1 / perUnit;
    axis = glm::dvec3(w) / perUnit;
  } else {
    axis = direction(middle[0], middle[1]);
    const double near = glm::dot(axis, glm::dvec3(middle[0]) / middle[0].w);
    start_ = std::min(near, 0.0);
    depth_ = {axis, -start_};
  }
  const glm::dvec3 across = direction(middle[0], eyeFromClip * glm::dvec4(1, 0, nearest, 1));
  right_ = unit(across - glm::dot(across, axis) * axis);
  up_ = glm::cross(axis, right_);
  if (perspective)
    angle_ = 1 / std::abs(unit_ * glm::dot(glm::dvec3(glm::transpose(camera.clipFromEye)[1]), up_));
}

double LensAxis::distanceOf(const glm::dvec3& eye) const { return glm::dot(depth_, glm::dvec4(eye, 1)); }

LensShear LensAxis::shear(double radius, double focus) const {
  return {glm::dvec4(0, 0, 0, 1) - depth_ / focus, radius * unit_ * right_, radius * unit_ * up_};
}

double LensAxis::radius(const Settings::Camera& camera, double focus) const {
  if (!(camera.fNumber > 0)) return double{camera.aperture};
  if (!(angle_ > 0) || !std::isfinite(angle_)) return 0;
  const double behind = double{camera.film} / (2 * angle_);  // from the lens to the film
  const double focalLength = 1 / (1 / focus + 1 / behind);
  return focalLength / (2 * double{camera.fNumber});
}

std::unique_ptr<const Lens> makeLens(const scene::Snapshot& snapshot, double focus) {
  if (!(focus > 0) || !std::isfinite(focus)) return nullptr;
  const LensAxis axis(snapshot.camera);
  const double radius = axis.radius(snapshot.settings.camera, focus);
  if (!(radius > 0)) return nullptr;
  const LensShear eye = axis.shear(radius, focus);
  auto lens = std::make_unique<Lens>();
  lens->world = eye.in(snapshot.eyeFromWorld);
  lens->objects.reserve(snapshot.instances.size());
  lens->lightings.resize(snapshot.instances.size());
  for (const scene::Instance& instance : snapshot.instances) {
    lens->objects.push_back(eye.in(instance.eyeFromObject));
    if (instance.mesh->shape == scene::Shape::triangles || instance.mesh->triangleCount == 0) continue;
    const glm::dmat4 objectFromLighting =
        inverseOf(glm::dmat4(instance.lightingFromObject), "an instance's lighting matrix");
    lens->lightings[lens->objects.size() - 1] = lens->objects.back().in(objectFromLighting);
  }
  return lens;
}

}  // namespace gluray::render
