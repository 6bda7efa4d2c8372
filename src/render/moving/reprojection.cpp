#include "render/moving/reprojection.h"

#include "scene/secondary_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gluray::render {

void Placement::rememberScene(const scene::Snapshot& s) {
  eyeFromWorld = s.eyeFromWorld;
  objects.resize(scene::countAll(s));
  for (size_t i = 0; i < objects.size(); ++i) {
    const scene::Instance& instance = scene::instanceOf(s, i);
    Object& object = objects[i];
    object.geometry = instance.mesh->geometryId, object.triangles = instance.mesh->triangleCount;
    object.eyeFromObject = instance.eyeFromObject;
    object.radius = instance.mesh->radius / instance.impostors.radiusDivisor;
    object.clipPlanes.clear();
    for (const glm::dvec4& plane : instance.clipPlanes)
      object.clipPlanes.push_back(plane * instance.eyeFromObject);
  }
}

namespace {

using Corners = std::array<glm::dvec4, 8>;  // of the world's bounds, eye space

Corners cornersOf(const FrameData& frame) {
  const accel::Bounds seen = frame.world->seenBounds();
  const glm::dvec3 ends[] = {seen.lower, seen.upper};
  Corners corners;
  for (size_t i = 0; i < corners.size(); ++i)
    corners[i] =
        frame.snapshot->eyeFromWorld * glm::dvec4(ends[i & 1].x, ends[i >> 1 & 1].y, ends[i >> 2].z, 1);
  return corners;
}

/// Whether two transforms put all of the world to the same pixels.
bool isSameMotion(const glm::dmat4& a, const glm::dmat4& b, const Corners& corners, const PixelSpace& space) {
  constexpr double kUnseen = 0.05;  // of a pixel's width
  for (const glm::dvec4& corner : corners) {
    const glm::dvec4 p = a * corner;
    const double depth = glm::dot(glm::dvec4(space.depth), glm::dvec4(glm::dvec3(p), 1));
    const double width = space.pixel + std::abs(depth) * space.perDepth;
    // Not <: what is no number has moved.
    if (!(glm::length(glm::dvec3(p - b * corner)) <= kUnseen * width)) return false;
  }
  return true;
}

bool isSamePlanes(const std::vector<glm::dvec4>& a, const std::vector<glm::dvec4>& b) {
  const auto isSame = [](const glm::dvec4& p, const glm::dvec4& q) {
    return glm::length(p - q) <= 1e-6 * (glm::length(p) + glm::length(q));
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), isSame);
}

bool isSameObject(const Placement::Object& a, const Placement::Object& b) {
  return a.geometry == b.geometry && a.triangles == b.triangles && a.radius == b.radius &&
         isSamePlanes(a.clipPlanes, b.clipPlanes);
}

glm::dmat4 motionOf(const Placement::Object& earlier, const Placement::Object& now) {
  return earlier.eyeFromObject * glm::inverse(now.eyeFromObject);
}

}  // namespace

Reprojection::Reprojection(const Placement& earlier, const PixelSpace& earlierSpace, const Placement& now,
                           const FrameData& frame) {
  const size_t known = std::min(earlier.objects.size(), now.objects.size());
  const Corners corners = cornersOf(frame);
  std::vector<uint8_t> still;
  const auto follow = [&](const glm::dmat4& motion) {
    uint64_t triangles = 0;
    still.assign(now.objects.size(), 0);
    for (size_t i = 0; i < known; ++i) {
      const Placement::Object &then = earlier.objects[i], &object = now.objects[i];
      if (!isSameObject(then, object)) continue;
      if (!isSameMotion(motion, motionOf(then, object), corners, earlierSpace)) continue;
      still[i] = 1, triangles += object.triangles;
    }
    return triangles;
  };
  // The camera's motion is that of the world or of the largest object, whichever more triangles follow.
  glm::dmat4 motion = earlier.eyeFromWorld * glm::inverse(now.eyeFromWorld);
  const uint64_t withWorld = follow(motion);
  size_t largest = 0;
  uint64_t all = 0;
  for (size_t i = 0; i < known; ++i) {
    all += now.objects[i].triangles;
    if (now.objects[i].triangles > now.objects[largest].triangles) largest = i;
  }
  if (withWorld < all) {
    const glm::dmat4 other = motionOf(earlier.objects[largest], now.objects[largest]);
    if (follow(other) > withWorld)
      motion = other;
    else
      follow(motion);
  }
  changed =
      earlier.objects.size() != now.objects.size() || std::find(still.begin(), still.end(), 0) != still.end();
  if (changed) {
    moved.resize(still.size());
    std::transform(still.begin(), still.end(), moved.begin(), [](uint8_t s) { return uint8_t(s == 0); });
  }
  earlierFromEye = glm::mat4(motion);
  const glm::dmat3 linear(motion);
  earlierFromEyeNormal = glm::mat3(glm::transpose(glm::inverse(linear)));
  earlierPixelFromEye = glm::mat4(earlierSpace.pixelFromEye * motion);
}

}  // namespace gluray::render
