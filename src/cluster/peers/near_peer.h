// A peer whose surfaces may lie in the way of a rank's rays: which rays it is asked about, and how. Made when
// a picture begins, read by all tracing threads.
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
  /// Of its surfaces, in the space of the rank's own viewFromWorld; to the bit as the peer has them where
  /// both have one space.
  const accel::Bounds& bounds() const { return bounds_; }
  /// Those of `lanes` whose rays may meet its surfaces.
  uint32_t mayMeet(const accel::OcclusionRays& rays, uint32_t lanes) const;
  /// The query as the peer gets it: in its own world.
  QueryPacket packetOf(const render::RemoteQuery& query, uint32_t lanes) const;

 private:
  int rank_;
  uint64_t round_;
  accel::Bounds bounds_, inWorld_;  // in this rank's world, with a margin for rounding
  bool sameWorld_ = false, sameEye_ = false;
  glm::dmat4 peerFromWorld_{1}, peerFromEye_{1};
};

}  // namespace gluray::cluster
