// A peer whose surfaces may block a rank's rays: selects the rays to query, and transforms them. Made when an
// image begins, read by all tracing threads.
#pragma once
#include "cluster/messages/peer_messages.h"
#include "cluster/peers/query_stream.h"
#include "render/remote/remote_surfaces.h"

#include <cstdint>

namespace gluray::cluster {

class NearPeer {
 public:
  /// `eyeFromPeer`: from its eye space to that of `own`.
  NearPeer(const SceneHeld& own, const SceneHeld& peer, const glm::dmat4& eyeFromPeer);

  int rank() const { return rank_; }
  uint64_t round() const { return round_; }
  const render::DrawnPart& drawn() const { return drawn_; }
  /// Bounds of its surfaces, in the space of the rank's own viewFromWorld; equal to the peer's bounds to the
  /// bit if both spaces are equal.
  const accel::Bounds& bounds() const { return bounds_; }
  /// The subset of `lanes` whose rays may hit its surfaces.
  uint32_t mayMeet(const accel::OcclusionRays& rays, uint32_t lanes) const;
  /// The query in the peer's world space.
  QueryPacket packetOf(const render::RemoteQuery& query, uint32_t lanes) const;

 private:
  int rank_;
  uint64_t round_;
  render::DrawnPart drawn_;
  accel::Bounds bounds_, inWorld_;  // in this rank's world, with a margin for rounding
  bool sameWorld_ = false, sameEye_ = false;
  glm::dmat4 peerFromWorld_{1}, peerFromEye_{1};
};

}  // namespace gluray::cluster
