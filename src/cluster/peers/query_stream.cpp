#include "cluster/peers/query_stream.h"

#include <bit>

namespace gluray::cluster {
namespace {

enum Flag : uint8_t { kShadow = 1, kLamp = 2, kKnownOrigins = 4, kOneLength = 8, kAllFlags = 15 };

template <class Do>
void eachLane(uint32_t lanes, const Do& act) {
  for (; lanes; lanes &= lanes - 1) act(std::countr_zero(lanes));
}

bool sameBits(const glm::vec3& a, const glm::vec3& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

glm::vec3 originOf(const accel::OcclusionRays& rays, int lane) {
  return {rays.orgX[lane], rays.orgY[lane], rays.orgZ[lane]};
}

}  // namespace

void QueryWriter::add(const QueryPacket& packet) {
  const uint32_t lanes = packet.lanes;
  const accel::OcclusionRays& rays = packet.rays;
  bool known = (lanes & ~known_) == 0, oneLength = true;
  const int first = std::countr_zero(lanes);
  eachLane(lanes, [&](int i) {
    known = known && sameBits(origins_[static_cast<size_t>(i)], originOf(rays, i));
    oneLength =
        oneLength && std::bit_cast<uint32_t>(rays.tFar[i]) == std::bit_cast<uint32_t>(rays.tFar[first]);
  });
  const int flags = (packet.kind == accel::RayKind::shadow ? kShadow : 0) | (packet.lamp ? kLamp : 0) |
                    (known ? kKnownOrigins : 0) | (oneLength ? kOneLength : 0);
  out_.put(static_cast<uint16_t>(lanes));
  out_.put(static_cast<uint8_t>(flags));
  if (packet.lamp) out_.put(*packet.lamp);
  if (!known) eachLane(lanes, [&](int i) { out_.put(origins_[static_cast<size_t>(i)] = originOf(rays, i)); });
  if (!known) known_ = lanes;
  eachLane(lanes, [&](int i) { out_.put(glm::vec3(rays.dirX[i], rays.dirY[i], rays.dirZ[i])); });
  if (oneLength)
    out_.put(rays.tFar[first]);
  else
    eachLane(lanes, [&](int i) { out_.put(rays.tFar[i]); });
  rays_ += static_cast<size_t>(std::popcount(lanes));
}

bool QueryReader::nextPacket(QueryPacket& packet) {
  if (in_.left() == 0) return false;
  packet.lanes = in_.get<uint16_t>();
  const auto flags = in_.get<uint8_t>();
  if (packet.lanes == 0 || flags > kAllFlags) throw Malformed("a packet of queries has no rays");
  packet.kind = flags & kShadow ? accel::RayKind::shadow : accel::RayKind::occlusion;
  packet.lamp = flags & kLamp ? std::optional(in_.get<glm::vec3>()) : std::nullopt;
  if (flags & kKnownOrigins) {
    if (packet.lanes & ~known_) throw Malformed("queries lack their origins");
  } else {
    known_ = packet.lanes;
    eachLane(known_, [&](int i) { origins_[static_cast<size_t>(i)] = in_.get<glm::vec3>(); });
  }
  accel::OcclusionRays& rays = packet.rays;
  eachLane(packet.lanes, [&](int i) {
    const glm::vec3& origin = origins_[static_cast<size_t>(i)];
    const auto direction = in_.get<glm::vec3>();
    rays.orgX[i] = origin.x, rays.orgY[i] = origin.y, rays.orgZ[i] = origin.z, rays.tNear[i] = 0;
    rays.dirX[i] = direction.x, rays.dirY[i] = direction.y, rays.dirZ[i] = direction.z;
  });
  const float length = flags & kOneLength ? in_.get<float>() : 0;
  eachLane(packet.lanes, [&](int i) { rays.tFar[i] = flags & kOneLength ? length : in_.get<float>(); });
  return true;
}

void AnswerWriter::add(const AnswerPacket& packet) {
  out_.put(static_cast<uint8_t>(packet.partly != 0));
  out_.put(static_cast<uint16_t>(packet.blocked));
  if (!packet.partly) return;
  out_.put(static_cast<uint16_t>(packet.partly));
  eachLane(packet.partly, [&](int i) { out_.put(packet.through[static_cast<size_t>(i)]); });
}

AnswerPacket AnswerReader::nextPacket(uint32_t lanes) {
  AnswerPacket packet;
  const auto some = in_.get<uint8_t>();
  packet.blocked = in_.get<uint16_t>();
  if (some > 1) throw Malformed("an answer is of no kind");
  if (some) packet.partly = in_.get<uint16_t>();
  if ((packet.blocked | packet.partly) & ~lanes || packet.blocked & packet.partly)
    throw Malformed("an answer to what was not asked");
  eachLane(packet.partly, [&](int i) {
    glm::vec3& through = packet.through[static_cast<size_t>(i)];
    through = in_.get<glm::vec3>();
    for (int c = 0; c < 3; ++c)
      if (!(through[c] >= 0 && through[c] <= 1)) throw Malformed("more passes than there is");
  });
  return packet;
}

}  // namespace gluray::cluster
