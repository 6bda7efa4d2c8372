#include "accel/ground.h"

#include "scene/effects.h"

#include <cmath>
#include <limits>

namespace gluray::accel {
namespace {

/// Where the viewer stands on the ray.
double viewerOn(const glm::dvec4& viewer, const glm::dvec3& org, const glm::dvec3& dir) {
  if (viewer.w == 0) return -std::numeric_limits<double>::infinity();
  const double size = std::abs(dir.x) + std::abs(dir.y) + std::abs(dir.z);
  const glm::dvec3 unit = dir / size;  // squares neither overflow nor vanish
  return glm::dot(glm::dvec3(viewer) / viewer.w - org, unit) / (glm::dot(unit, unit) * size);
}

void writeHit(RayPacket& p, int i, double x, double y, double half) {
  const double a = (x + half) / (2 * half), b = (y + half) / (2 * half);  // 0 .. 1 along both sides
  const bool first = a >= b;
  p.primitive[i] = first ? 0 : 1;
  p.u[i] = static_cast<float>(first ? a - b : a);
  p.v[i] = static_cast<float>(first ? b : b - a);
  p.normalX[i] = p.normalY[i] = 0, p.normalZ[i] = 1;
  p.geometry[i] = 0;
}

}  // namespace

Ground::Ground(const scene::Snapshot& s) {
  for (size_t i = 0; i < s.instances.size(); ++i)
    if (s.instances[i].ground) instance_ = static_cast<uint32_t>(i);
  if (!exists()) return;
  const scene::Instance& ground = s.instances[instance_];
  catches_ = scene::wantsCatcher(s.settings);
  half_ = double{ground.mesh->upper.x};
  objectFromWorld_ = glm::inverse(glm::dmat4(ground.worldFromObject));
  const glm::dmat4 worldFromClip = glm::inverse(s.camera.clipFromEye * s.eyeFromWorld);
  viewer_ = worldFromClip[2];
  const double size = glm::length(glm::dvec3(viewer_));
  if (!(std::abs(viewer_.w) * half_ > 1e-12 * size)) viewer_.w = 0;  // parallel but for rounding
}

void Ground::extend(glm::vec3& lower, glm::vec3& upper) const {
  if (!exists()) return;
  const glm::dmat4 worldFromObject = glm::inverse(objectFromWorld_);
  for (int corner = 0; corner < 4; ++corner) {
    const glm::vec3 at(worldFromObject *
                       glm::dvec4(corner & 1 ? half_ : -half_, corner & 2 ? half_ : -half_, 0, 1));
    lower = glm::min(lower, at), upper = glm::max(upper, at);
  }
}

void Ground::intersect(const int32_t* valid, RayPacket& p) const noexcept {
  for (int i = 0; i < kLanes; ++i) {
    const bool met = p.geometry[i] != kNoHit;
    if (!valid[i] || (met && catches_)) continue;
    const glm::dvec3 org(p.orgX[i], p.orgY[i], p.orgZ[i]), dir(p.dirX[i], p.dirY[i], p.dirZ[i]);
    const glm::dvec3 from(objectFromWorld_ * glm::dvec4(org, 1)), along = glm::dmat3(objectFromWorld_) * dir;
    const double t = -from.z / along.z;
    if (!std::isfinite(t) || (met && t >= double{p.tFar[i]})) continue;
    if (p.tNear[i] > 0 ? !(t > double{p.tNear[i]}) : !(t > viewerOn(viewer_, org, dir))) continue;
    const double x = from.x + t * along.x, y = from.y + t * along.y;
    if (!(std::abs(x) <= half_ && std::abs(y) <= half_)) continue;
    writeHit(p, i, x, y, half_);
    p.instance[i] = instance_;
    p.tFar[i] = static_cast<float>(t);
  }
}

}  // namespace gluray::accel
