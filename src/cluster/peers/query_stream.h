// Lossless serialisation of occlusion queries and answers: packets of rays in the order of the queries.
// Repeated origins, such as those of several samples at one point, are written once. Any thread.
#pragma once
#include "accel/rays/occlusion.h"
#include "accel/rays/ray_kind.h"
#include "cluster/stream/byte_stream.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gluray::cluster {

/// Rays of one packet, for the lanes in `lanes`.
struct QueryPacket {
  uint32_t lanes = 0;
  accel::RayKind kind = accel::RayKind::occlusion;  // or shadow
  std::optional<glm::vec3> lamp;                    // render::RemoteQuery::lamp, in the receiver's eye space
  accel::OcclusionRays rays;                        // origins, directions and tFar of those lanes
};

class QueryWriter {
 public:
  void add(const QueryPacket& packet);
  size_t rays() const { return rays_; }
  std::vector<std::byte> takeBytes() { return out_.takeBytes(); }

 private:
  ByteWriter out_;
  size_t rays_ = 0;
  uint32_t known_ = 0;  // lanes of origins_
  std::array<glm::vec3, accel::kLanes> origins_;
};

class QueryReader {
 public:
  explicit QueryReader(std::span<const std::byte> bytes) : in_(bytes) {}
  /// Returns false if there are no more packets. Sets tNear to 0. Throws Malformed.
  bool nextPacket(QueryPacket& packet);

 private:
  ByteReader in_;
  uint32_t known_ = 0;
  std::array<glm::vec3, accel::kLanes> origins_;
};

/// Answer to one packet of queries.
struct AnswerPacket {
  uint32_t blocked = 0;
  uint32_t partly = 0;                           // lanes with partial transmittance
  std::array<glm::vec3, accel::kLanes> through;  // transmittance of these lanes
};

class AnswerWriter {
 public:
  void add(const AnswerPacket& packet);
  std::vector<std::byte> takeBytes() { return out_.takeBytes(); }

 private:
  ByteWriter out_;
};

class AnswerReader {
 public:
  explicit AnswerReader(std::span<const std::byte> bytes) : in_(bytes) {}
  /// Reads the answer to the next packet, whose query had `lanes`. Throws Malformed.
  AnswerPacket nextPacket(uint32_t lanes);
  bool atEnd() const { return in_.left() == 0; }

 private:
  ByteReader in_;
};

}  // namespace gluray::cluster
