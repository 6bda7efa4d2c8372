#include "accel/placement.h"

#include "accel/device/embree.h"
#include "scene/box_corner.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

/// Largest absolute value of an element.
double largest(const glm::dvec3& v) {
  const glm::dvec3 size = glm::abs(v);
  return std::max({size.x, size.y, size.z});
}
double largest(const glm::dmat3& m) { return std::max({largest(m[0]), largest(m[1]), largest(m[2])}); }

double sum(const glm::vec3& v) {
  return double{std::abs(v.x)} + double{std::abs(v.y)} + double{std::abs(v.z)};
}

constexpr double kRounded = 0x1p-22;  // four roundings of floats

/// An affine camera.
struct Eye {
  explicit Eye(const glm::dmat4& eyeFromWorld)
      : turn(eyeFromWorld), at(eyeFromWorld[3]), turned(largest(turn)) {}
  glm::dmat3 turn;
  glm::dvec3 at;
  double turned;  // largest element
};

/// Bounds, along the axes of eye space, of the rounding of the columns of an instance's transform.
///
/// OpenGL keeps products of float matrices. An element of one is a sum of products, whose rounding is below
/// 2^-22 of the sum of their absolute values: of those of the transform, turned, and for a translation that
/// of the camera along the same axis. An axis along which the camera is far away says nothing about the
/// others: what moves across the view of a distant camera moves visibly.
glm::dmat4x3 roundingOf(const Eye& eye, const glm::mat4& worldFromObject) {
  constexpr double kSolved = 0x1p-46;  // of the inverse of the camera, in doubles
  double linear = 0;
  for (int c = 0; c < 3; ++c) linear = std::max(linear, largest(eye.turn * glm::dvec3(worldFromObject[c])));
  glm::dmat4x3 bounds;
  for (int c = 0; c < 4; ++c)
    bounds[c] = glm::dvec3(kRounded * (eye.turned * sum(worldFromObject[c]) + (c < 3 ? linear : 0)));
  const glm::dvec3 inEye = eye.turn * glm::dvec3(worldFromObject[3]) + eye.at;
  bounds[3] += kRounded * (glm::abs(inEye) + glm::abs(eye.at)) + kSolved * largest(eye.at);
  return bounds;
}

/// Whether the columns of two transforms differ by so little that any roundingOf() exceeds it.
bool isRounding(const glm::mat4& now, const glm::mat4& then) {
  for (int c = 0; c < 4; ++c)
    if (!(sum(glm::vec3(now[c]) - glm::vec3(then[c])) <= kRounded * sum(now[c]))) return false;
  return true;
}

/// Whether the columns of a difference, turned, are within bounds.
bool isWithin(const glm::dmat3& turn, const glm::mat4& now, const glm::mat4& then,
              const glm::dmat4x3& bounds) {
  for (int c = 0; c < 4; ++c) {
    const glm::dvec3 moved = glm::abs(turn * (glm::dvec3(now[c]) - glm::dvec3(then[c])));
    if (!(moved.x <= bounds[c].x && moved.y <= bounds[c].y && moved.z <= bounds[c].z)) return false;
  }
  return true;
}

}  // namespace

/// OpenGL stores the product of camera and instance transform as floats. The instance transforms recovered
/// from it vary from frame to frame by rounding, about a thousandth of a pixel. Without this check, a moving
/// camera would rebuild the TLAS. What is held was rounded along the axes of the camera of its own frame,
/// which `turn` turns to those of the present one. All instances stay or none: coincident surfaces must not
/// separate.
bool stayPlaced(const glm::dmat4& eyeFromWorld, const Tlas& tlas, const std::vector<PlacedBlas>& placed) {
  const std::vector<PlacedBlas>& held = tlas.held();
  if (held.size() != placed.size()) return false;
  const Eye eye(eyeFromWorld), earlier(tlas.heldFrom());
  glm::dmat3 turn = eye.turn * glm::inverse(earlier.turn);
  for (int c = 0; c < 3; ++c) turn[c] = glm::abs(turn[c]);
  for (size_t i = 0; i < placed.size(); ++i) {
    if (placed[i].blas != held[i].blas) return false;
    const glm::mat4 &now = placed[i].worldFromObject, &then = held[i].worldFromObject;
    if (now == then || isRounding(now, then)) continue;
    if (!isWithin(eye.turn, now, then, roundingOf(eye, now) + turn * roundingOf(earlier, then))) return false;
  }
  return true;
}

Bounds boundsOf(RTCSceneTy* scene) {
  RTCBounds b;
  rtcGetSceneBounds(scene, &b);
  return {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
}

Bounds boundsIn(const glm::dmat4& spaceFromWorld, const std::vector<PlacedBlas>& instances) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Bounds all{glm::vec3(kInfinity), glm::vec3(-kInfinity)};
  for (const PlacedBlas& placed : instances) {
    if (!placed.blas) continue;
    const Bounds box = boundsOf(placed.blas->scene());
    if (box.empty()) continue;
    const glm::dmat4 place = spaceFromWorld * glm::dmat4(placed.worldFromObject);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 p(place * glm::dvec4(scene::boxCorner(box.lower, box.upper, corner), 1));
      all.lower = glm::min(all.lower, p), all.upper = glm::max(all.upper, p);
    }
  }
  return all;
}

}  // namespace gluray::accel
