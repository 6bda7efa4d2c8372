// VolumeRays: rays that end on the faces of a box (scene::VolumeSpan).
#include "render/volumes/volume_rays.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

glm::dvec3 pointAt(const glm::dmat4& m, const glm::dvec3& data) {
  const glm::dvec4 p = m * glm::dvec4(data, 1);
  return glm::dvec3(p) / p.w;
}

}  // namespace

/// The ray to one of the faces that cover the pixel: those in front of the box have no steps.
VolumeRay VolumeRays::spanAt(int x, int y, const Faces& faces) const {
  const glm::dvec2 centre = glm::dvec2(view_.region.x + x, view_.region.y + y) + 0.5;
  const glm::dvec4& window = view_.span->window;
  if (centre.x < window.x || centre.x > window.y || centre.y < window.z || centre.y > window.w) return {};
  for (const uint32_t number : faces) {
    if (!faces_[number].covers(centre)) continue;
    const FacePoint end = pointOf(faces_[number], centre);
    const VolumeRay ray = end.visible() ? spanTo(end) : VolumeRay{};
    if (ray.samples > 0) return ray;
  }
  return {};
}

VolumeRay VolumeRays::spanTo(const FacePoint& end) const {
  const scene::VolumeSpan& span = *view_.span;
  const glm::dvec3 near = pointAt(span.nearFromData, end.data), far = pointAt(span.farFromData, end.data);
  const glm::dvec3 along = glm::normalize(far - near);
  double distance = glm::dot(near - end.data, along);
  for (int axis = 0; axis < 3; ++axis)
    distance = std::max(distance, std::min((-0.5 - end.data[axis]) / along[axis],
                                           (span.size[axis] - 0.5 - end.data[axis]) / along[axis]));
  VolumeRay ray;
  const double steps = std::trunc(-distance / span.step + 0.5);
  if (!(steps >= 1 && steps <= kMostSamples)) return ray;
  const glm::dvec3 front = end.data + along * distance;
  ray.first = (front + span.shift) / span.size;
  ray.step = (end.data - front) / span.size / steps;
  ray.towardsViewer = -along;
  ray.samples = static_cast<int>(steps), ray.depth = static_cast<float>(end.depth);
  return ray;
}

}  // namespace gluray::render
