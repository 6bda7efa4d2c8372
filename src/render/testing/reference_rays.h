// The rays of a volume's pixels by the geometry of the box, in doubles: without faces, sample by sample.
#pragma once
#include "render/testing/test_volume_view.h"
#include "scene/volumes/volume.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gluray::test {

/// A ray that is walked as the loop of a fragment shader does.
struct ReferenceRay {
  bool hits = false;
  glm::dvec3 entry{0};  // data space
  double depth = 0;     // window depth of the entry
  int side = -1;        // of the box where it enters: axis; -1: the near plane
  glm::dvec3 first{0}, step{0};
  int samples = 0;
  bool unsure = false;  // a sample lies so near to an end of the ray that rounding decides whether it counts
};

/// Where the line through a pixel's centre enters the box, from the near plane on.
inline void enterBox(const scene::VolumeView& view, const VolumeBox& box, const glm::dvec2& pixel,
                     ReferenceRay& ray) {
  const glm::dmat4 dataFromWindow = glm::inverse(view.windowFromData);
  const auto at = [&](double depth) {
    const glm::dvec4 p = dataFromWindow * glm::dvec4(pixel, depth, 1);
    return glm::dvec3(p) / p.w;
  };
  const glm::dvec3 begin = at(0), along = at(1) - begin;
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.lower[axis] - begin[axis]) / along[axis],
                 b = (box.upper[axis] - begin[axis]) / along[axis];
    if (std::min(a, b) > enter) enter = std::min(a, b), ray.side = axis;
    leave = std::min(leave, std::max(a, b));
  }
  ray.hits = enter < leave;
  ray.entry = begin + enter * along;
  const glm::dvec4 window = view.windowFromData * glm::dvec4(ray.entry, 1);
  ray.depth = window.z / window.w;
}

/// Whether the pixel's centre is so near to an edge of the box that rounding of its corners to 1/256 pixel
/// decides which side the ray enters.
inline bool isAtEdge(const scene::VolumeView& view, const VolumeBox& box, const glm::dvec2& pixel,
                     const ReferenceRay& ray) {
  for (const glm::dvec2& aside : {glm::dvec2(1, 1), {1, -1}, {-1, 1}, {-1, -1}}) {
    ReferenceRay other;
    enterBox(view, box, pixel + aside / 256.0, other);
    if (other.hits != ray.hits || (ray.hits && other.side != ray.side)) return true;
  }
  return false;
}

/// Counts the samples: each is taken before the ray's ends are looked at.
inline void walk(const scene::VolumeView& view, const glm::dvec3& end, ReferenceRay& ray) {
  constexpr double kNear = 5e-7;  // texture space: rounding of floats
  const glm::dvec3 last(view.textureFromData * glm::dvec4(end, 1));
  const double steps = glm::length(last - ray.first) / glm::length(ray.step);
  glm::dvec3 at = ray.first;
  for (int taken = 0;; ++taken) {
    ray.samples = taken + 1;
    at = ray.first + ray.step * (taken + 1.0);
    bool outside = false;
    for (int axis = 0; axis < 3; ++axis) {
      const double past = ray.step[axis] > 0   ? at[axis] - double{view.upper[axis]}
                          : ray.step[axis] < 0 ? double{view.lower[axis]} - at[axis]
                                               : -1;
      outside |= past > 0;
      ray.unsure |= std::abs(past) < kNear && std::abs(ray.step[axis]) > 1e-12;
    }
    ray.unsure |= std::abs(taken - steps) < 1e-4;
    if (outside || taken >= steps) return;
  }
}

/// Moves the ends of a ray that lie behind planes of data space, one plane after the other.
inline void clip(const scene::VolumeView& view, glm::dvec3& begin, glm::dvec3& end, ReferenceRay& ray) {
  constexpr double kNear = 1e-6;
  if (!view.clipping) return;
  for (const glm::dvec4& plane : view.clipping->planes) {
    const glm::dvec3 normal(plane);
    const double a = glm::dot(normal, begin) + plane.w, b = glm::dot(normal, end) + plane.w;
    ray.unsure |= std::abs(a) < kNear || std::abs(b) < kNear;
    if (a < 0 && b < 0) ray.hits = false;
    const glm::dvec3 cut = begin + (end - begin) * (a / (a - b));
    if (a < 0 && b > 0) begin = cut;
    if (b < 0 && a > 0) end = cut;
  }
}

/// Where the ray enters the grid after its first step.
inline void beginInside(const scene::VolumeView& view, ReferenceRay& ray) {
  constexpr double kNear = 5e-7;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = double{view.lower[axis]} - ray.first[axis],
                 above = ray.first[axis] - double{view.upper[axis]};
    ray.unsure |= std::abs(below) < kNear || std::abs(above) < kNear;
    if (below > 0 || above > 0) ray.hits = false;
  }
}

inline ReferenceRay referenceRay(const scene::VolumeView& view, const VolumeBox& box, int x, int y) {
  ReferenceRay ray;
  const glm::dvec2 pixel(view.region.x + x + 0.5, view.region.y + y + 0.5);
  enterBox(view, box, pixel, ray);
  ray.unsure = isAtEdge(view, box, pixel, ray);
  if (!ray.hits) return ray;
  double end = 1;
  if (!view.depth.empty()) {
    end = double{view.depth[static_cast<size_t>(y * view.region.width + x)]};
    ray.hits = ray.depth < end;
    ray.unsure |= std::abs(ray.depth - end) < 1e-7;
    if (!ray.hits) return ray;
  }
  const glm::dvec3 away = view.direction != glm::dvec3(0) ? view.direction : ray.entry - view.viewer;
  ray.step = glm::dmat3(view.textureFromData) * (glm::normalize(away) * double{view.step});
  const glm::dvec4 behind = glm::inverse(view.windowFromData) * glm::dvec4(pixel, end, 1);
  glm::dvec3 begin = ray.entry, last = glm::dvec3(behind) / behind.w;
  clip(view, begin, last, ray);
  ray.first = glm::dvec3(view.textureFromData * glm::dvec4(begin, 1)) + ray.step;
  if (view.clipping) beginInside(view, ray);
  if (ray.hits) walk(view, last, ray);
  return ray;
}

}  // namespace gluray::test
