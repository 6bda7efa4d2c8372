#include "cluster/peers/near_peer.h"

#include "scene/box_corner.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace gluray::cluster {
namespace {

accel::Bounds transformed(const glm::dmat4& m, const glm::vec3& lower, const glm::vec3& upper) {
  constexpr float kMax = std::numeric_limits<float>::max();
  accel::Bounds box{glm::vec3(kMax), glm::vec3(-kMax)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 there(m * glm::dvec4(scene::boxCorner(lower, upper, corner), 1));
    box.lower = glm::min(box.lower, there), box.upper = glm::max(box.upper, there);
  }
  return box;
}

/// Rays are rounded, and so are surfaces: asks rather once too often.
accel::Bounds widened(const accel::Bounds& box) {
  constexpr float kRounding = 1e-4f;
  const glm::vec3 size = box.upper - box.lower, reach = glm::max(glm::abs(box.lower), glm::abs(box.upper));
  const float margin =
      kRounding * std::max({size.x, size.y, size.z}) + 1e-6f * std::max({reach.x, reach.y, reach.z});
  return {box.lower - margin, box.upper + margin};
}

}  // namespace

NearPeer::NearPeer(const SceneHeld& own, const SceneHeld& peer, const glm::dmat4& eyeFromPeer)
    : rank_(peer.address.from), round_(peer.round), drawn_(peer.drawn), bounds_{peer.lower, peer.upper} {
  sameEye_ = eyeFromPeer == glm::dmat4(1);
  sameWorld_ = sameEye_ && own.eyeFromWorld == peer.eyeFromWorld;
  if (!sameEye_) peerFromEye_ = glm::inverse(eyeFromPeer);
  const glm::dmat4 worldFromPeer =
      sameWorld_ ? glm::dmat4(1) : glm::inverse(own.eyeFromWorld) * eyeFromPeer * peer.eyeFromWorld;
  if (!sameWorld_) peerFromWorld_ = glm::inverse(worldFromPeer);
  const glm::dmat4 worldFromPeersView = worldFromPeer * glm::inverse(peer.viewFromWorld);
  inWorld_ = widened(transformed(worldFromPeersView, peer.lower, peer.upper));
  if (!sameWorld_ || own.viewFromWorld != peer.viewFromWorld)
    bounds_ = transformed(own.viewFromWorld * worldFromPeersView, peer.lower, peer.upper);
}

/// Slabs (T. Kay, J. Kajiya, "Ray Tracing Complex Scenes", 1986), of all lanes at once.
uint32_t NearPeer::mayMeet(const accel::OcclusionRays& rays, uint32_t lanes) const {
  constexpr int kLanes = accel::kLanes;
  float from[kLanes] = {}, to[kLanes];
  std::copy_n(rays.tFar, kLanes, to);
  const float* const org[] = {rays.orgX, rays.orgY, rays.orgZ};
  const float* const dir[] = {rays.dirX, rays.dirY, rays.dirZ};
  for (int axis = 0; axis < 3; ++axis) {
    const float lower = inWorld_.lower[axis], upper = inWorld_.upper[axis];
    for (int i = 0; i < kLanes; ++i) {
      const float inverse = 1 / dir[axis][i];
      const float a = (lower - org[axis][i]) * inverse, b = (upper - org[axis][i]) * inverse;
      const float near = a < b ? a : b, far = a < b ? b : a;
      from[i] = near > from[i] ? near : from[i];
      to[i] = far < to[i] ? far : to[i];
    }
  }
  uint32_t met = 0;
  for (int i = 0; i < kLanes; ++i) met |= static_cast<uint32_t>(!(from[i] > to[i])) << i;
  return met & lanes;
}

QueryPacket NearPeer::packetOf(const render::RemoteQuery& query, uint32_t lanes) const {
  QueryPacket packet;
  packet.lanes = lanes, packet.kind = query.kind;
  if (query.lamp) packet.lamp = sameEye_ ? *query.lamp : glm::vec3(peerFromEye_ * glm::dvec4(*query.lamp, 1));
  packet.rays = query.rays;
  if (sameWorld_) return packet;
  accel::OcclusionRays& rays = packet.rays;
  for (; lanes; lanes &= lanes - 1) {
    const int i = std::countr_zero(lanes);
    const glm::vec3 origin(peerFromWorld_ * glm::dvec4(rays.orgX[i], rays.orgY[i], rays.orgZ[i], 1));
    const glm::vec3 direction(peerFromWorld_ * glm::dvec4(rays.dirX[i], rays.dirY[i], rays.dirZ[i], 0));
    rays.orgX[i] = origin.x, rays.orgY[i] = origin.y, rays.orgZ[i] = origin.z;
    rays.dirX[i] = direction.x, rays.dirY[i] = direction.y, rays.dirZ[i] = direction.z;
  }
  return packet;
}

}  // namespace gluray::cluster
