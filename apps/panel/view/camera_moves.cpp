#include "view/camera_moves.h"

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace gluray::panel {
namespace {

glm::dvec3 vectorOf(const double (&v)[3]) { return {v[0], v[1], v[2]}; }

void put(const glm::dvec3& from, double (&to)[3]) {
  for (int i = 0; i < 3; ++i) to[i] = from[i];
}

/// The camera's own axes, of length 1.
struct Axes {
  glm::dvec3 right, up, back;
  double distance;  // from the focal point

  explicit Axes(const GlurayCamera& c) {
    const glm::dvec3 backward = vectorOf(c.position) - vectorOf(c.focalPoint);
    distance = glm::length(backward);
    back = backward / distance;
    right = glm::normalize(glm::cross(vectorOf(c.up), back));
    up = glm::cross(back, right);
  }
};

bool isParallel(const GlurayCamera& c) { return c.viewAngle == 0; }

/// Half the height of the view where the focal point is.
double halfHeight(const GlurayCamera& c, double distance) {
  return isParallel(c) ? c.parallelScale : distance * std::tan(glm::radians(c.viewAngle) / 2);
}

}  // namespace

double ViewShape::viewPixels() const {
  return windowHeight * std::min(static_cast<double>(pictureWidth) / windowWidth,
                                 static_cast<double>(pictureHeight) / windowHeight);
}

GlurayCamera turned(const GlurayCamera& camera, const double (&pivot)[3], double right, double up) {
  const Axes axes(camera);
  // The camera goes to the left where things turn to the right.
  const glm::dmat4 turn = glm::rotate(glm::dmat4(1), glm::radians(-right), axes.up) *
                          glm::rotate(glm::dmat4(1), glm::radians(up), axes.right);
  const glm::dvec3 middle = vectorOf(pivot);
  const auto around = [&](const glm::dvec3& p) {
    return middle + glm::dvec3(turn * glm::dvec4(p - middle, 0));
  };
  GlurayCamera result = camera;
  put(around(vectorOf(camera.position)), result.position);
  put(around(vectorOf(camera.focalPoint)), result.focalPoint);
  put(glm::normalize(glm::dvec3(turn * glm::dvec4(axes.up, 0))), result.up);
  return result;
}

GlurayCamera shifted(const GlurayCamera& camera, const ViewShape& shape, double right, double down) {
  const Axes axes(camera);
  const double unit = 2 * halfHeight(camera, axes.distance) / shape.viewPixels();
  const glm::dvec3 by = unit * (down * axes.up - right * axes.right);
  GlurayCamera result = camera;
  put(vectorOf(camera.position) + by, result.position);
  put(vectorOf(camera.focalPoint) + by, result.focalPoint);
  return result;
}

GlurayCamera zoomed(const GlurayCamera& camera, double factor) {
  GlurayCamera result = camera;
  if (isParallel(camera)) {
    result.parallelScale = camera.parallelScale / factor;
    return result;
  }
  const Axes axes(camera);
  put(vectorOf(camera.focalPoint) + axes.distance / factor * axes.back, result.position);
  return result;
}

GlurayCamera centredOn(const GlurayCamera& camera, const double (&point)[3]) {
  const glm::dvec3 by = vectorOf(point) - vectorOf(camera.focalPoint);
  GlurayCamera result = camera;
  put(vectorOf(camera.position) + by, result.position);
  put(vectorOf(point), result.focalPoint);
  return result;
}

GlurayCamera fitted(const GlurayCamera& camera, const ViewShape& shape, const double (&middle)[3],
                    double radius) {
  const Axes axes(camera);
  GlurayCamera result = centredOn(camera, middle);
  if (isParallel(camera)) {
    result.parallelScale = radius / shape.narrow();
    put(vectorOf(middle) + 2 * radius * axes.back, result.position);
    return result;
  }
  const double half = std::atan(std::tan(glm::radians(camera.viewAngle) / 2) * shape.narrow());
  put(vectorOf(middle) + radius / std::sin(half) * axes.back, result.position);
  return result;
}

bool areEqual(const GlurayCamera& a, const GlurayCamera& b) {
  return std::equal(a.position, a.position + 3, b.position) &&
         std::equal(a.focalPoint, a.focalPoint + 3, b.focalPoint) && std::equal(a.up, a.up + 3, b.up) &&
         a.viewAngle == b.viewAngle && a.parallelScale == b.parallelScale;
}

}  // namespace gluray::panel
