// The occlusion queries of one tile, in tracing order. The first trace records them, and stores the rays that
// may hit surfaces of peers. The second trace replays the answers. One thread at a time.
#pragma once
#include "cluster/peers/query_stream.h"
#include "render/remote/remote_surfaces.h"
#include "render/tiles/hidden_pixels.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace gluray::cluster {

class TileRecord {
 public:
  /// Whether the tile's eye rays have been traced.
  bool isSeen() const { return isSeen_; }
  void see() { isSeen_ = true; }

  /// Adds a query with the lanes `blocked` in this process. Returns its number.
  size_t add(uint32_t blocked);
  /// Adds query `number` for `peer` (an index below `peers`), in the peer's space.
  void ask(size_t number, int peer, const QueryPacket& packet);
  /// Whether there are queries to any peer.
  bool asks() const;
  size_t peers() const { return asked_.size(); }
  /// Returns the bytes for a peer; empty: no queries. Call once.
  std::vector<std::byte> queriesFor(int peer) {
    return asked_[static_cast<size_t>(peer)].queries.takeBytes();
  }
  size_t raysFor(int peer) const { return asked_[static_cast<size_t>(peer)].queries.rays(); }
  /// Throws Malformed if the answers do not match the queries.
  void answer(int peer, std::span<const std::byte> bytes);

  /// Starts the replay: queries are repeated from now on.
  void replay();
  bool replays() const { return replays_; }
  /// Sets the blocked lanes of the next query. Returns false, and stays at this query, if surfaces are
  /// translucent, so that the query must be made again.
  bool recall(uint32_t& blocked);
  /// Like recall(), after the query was made again: multiplies the transmittance.
  uint32_t combine(uint32_t blocked, render::Passing passing);

  explicit TileRecord(size_t peers) : asked_(peers) {}
  std::optional<render::HiddenPixels> hidden;  // none: not known yet

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
  bool replays_ = false, isSeen_ = false;
  size_t next_ = 0;
};

}  // namespace gluray::cluster
