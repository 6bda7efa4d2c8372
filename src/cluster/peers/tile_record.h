// The occlusion queries of one tile, in the order in which tracing it asks them. The first time they are
// recorded, and what may meet surfaces of peers is written down for these; the second time the answers are
// given. One thread at a time.
#pragma once
#include "cluster/peers/query_stream.h"
#include "render/remote/remote_surfaces.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace gluray::cluster {

class TileRecord {
 public:
  /// One more query; `blocked` here. Returns its number.
  size_t add(uint32_t blocked);
  /// Query `number` as `peer` (a number below peers) gets it.
  void ask(size_t number, int peer, const QueryPacket& packet);
  /// Whether any peer is asked.
  bool asks() const;
  size_t peers() const { return asked_.size(); }
  /// Bytes for a peer; empty: it is not asked. Once.
  std::vector<std::byte> queriesFor(int peer) {
    return asked_[static_cast<size_t>(peer)].queries.takeBytes();
  }
  size_t raysFor(int peer) const { return asked_[static_cast<size_t>(peer)].queries.rays(); }
  /// Throws Malformed where they are not the answers to what it was asked.
  void answer(int peer, std::span<const std::byte> bytes);

  /// From now on queries are repeated.
  void replay();
  bool replays() const { return replays_; }
  /// The lanes that are blocked, of the next query. False, and the next one stays: parts pass, so that the
  /// query must be made again.
  bool recall(uint32_t& blocked);
  /// The same after the query was made again: multiplies what passes.
  uint32_t combine(uint32_t blocked, render::Passing passing);

  explicit TileRecord(size_t peers) : asked_(peers) {}

 private:
  struct Call {
    uint16_t blocked = 0, partly = 0;
  };
  struct Part {
    uint32_t call = 0;
    int lane = 0;
    glm::vec3 through{1};
  };
  struct Asked {
    QueryWriter queries;
    std::vector<std::pair<uint32_t, uint16_t>> packets;  // number of the query, lanes
  };

  std::vector<Call> calls_;
  std::vector<Part> parts_;
  std::vector<Asked> asked_;
  bool replays_ = false;
  size_t next_ = 0;
};

}  // namespace gluray::cluster
