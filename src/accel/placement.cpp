#include "accel/placement.h"

#include "accel/embree.h"
#include "scene/surroundings.h"

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

/// Whether two affine transforms differ by at most `linear` per element, `along` in translations.
bool isNear(const glm::mat4& a, const glm::mat4& b, double linear, double along) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(double{a[c][r]} - double{b[c][r]}) <= (c < 3 ? linear : along))) return false;
  return true;
}

}  // namespace

/// OpenGL stores the product of camera and instance transform as floats. The instance transforms recovered
/// from it vary from frame to frame by rounding, about a thousandth of a pixel. Without this check, a moving
/// camera would rebuild the TLAS. All instances stay or none: coincident surfaces must not separate.
bool stayPlaced(const scene::Snapshot& snapshot, const std::vector<PlacedBlas>& held,
                const std::vector<PlacedBlas>& placed) {
  constexpr double kRounded = 0x1p-22;  // of the largest element: twice the spacing of floats
  if (held.size() != placed.size()) return false;
  const double camera = largest(glm::dvec3(snapshot.eyeFromWorld[3]));
  const double back = 3 * largest(glm::inverse(glm::dmat3(snapshot.eyeFromWorld)));
  for (size_t i = 0; i < placed.size(); ++i) {
    if (placed[i] == held[i]) continue;
    if (placed[i].blas != held[i].blas) return false;
    const glm::dmat4& inEye = scene::instanceOf(snapshot, i).eyeFromObject;
    const double linear = kRounded * back * largest(glm::dmat3(inEye));
    const double along = kRounded * back * (camera + largest(glm::dvec3(inEye[3])));
    if (!isNear(placed[i].worldFromObject, held[i].worldFromObject, linear, along)) return false;
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
      const glm::dvec4 at(corner & 1 ? box.upper.x : box.lower.x, corner & 2 ? box.upper.y : box.lower.y,
                          corner & 4 ? box.upper.z : box.lower.z, 1);
      const glm::vec3 p(place * at);
      all.lower = glm::min(all.lower, p), all.upper = glm::max(all.upper, p);
    }
  }
  return all;
}

}  // namespace gluray::accel
