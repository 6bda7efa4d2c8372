// A job of one process that counts what the ranks of a sort-last program ask each other.
#pragma once
#include "cluster/messages/peer_messages.h"
#include "cluster/peers/query_stream.h"
#include "cluster/ranks/alone.h"

#include <bit>
#include <mutex>
#include <utility>

namespace gluray::bench {

/// What the ranks have sent each other.
struct Traffic {
  double queryBytes = 0, answerBytes = 0, depthBytes = 0, rays = 0, messages = 0;
};

/// The worker's thread uses it as cluster::Ranks; take() any thread.
class CountingRanks final : public cluster::Ranks {
 public:
  int rank() const override { return alone_.rank(); }
  int size() const override { return alone_.size(); }
  int rankHere() const override { return alone_.rankHere(); }
  int sizeHere() const override { return alone_.sizeHere(); }
  std::string implementation() const override { return alone_.implementation(); }
  void send(int to, std::vector<std::byte> message) override {
    count(message);
    alone_.send(to, std::move(message));
  }
  std::optional<cluster::RankMessage> receive() override { return alone_.receive(); }
  void broadcast(int root, std::span<std::byte> bytes, std::function<void()> done) override {
    alone_.broadcast(root, bytes, std::move(done));
  }
  void progress() override { alone_.progress(); }
  bool busy() const override { return alone_.busy(); }
  Traffic take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(traffic_, {});
  }

 private:
  void count(const std::vector<std::byte>& message) {
    cluster::ByteReader in(message);
    const auto type = in.get<uint16_t>();
    if (type == cluster::TileDepths::kType) return countDepths(message.size());
    if (type != cluster::OcclusionQueries::kType && type != cluster::OcclusionReplies::kType) return;
    const auto bytes = static_cast<double>(message.size());
    const std::lock_guard lock(mutex_);
    ++traffic_.messages;
    if (type == cluster::OcclusionReplies::kType) {
      traffic_.answerBytes += bytes;
      return;
    }
    traffic_.queryBytes += bytes;
    const auto queries = cluster::decoded<cluster::OcclusionQueries>(in.readBytes(in.left()));
    cluster::QueryReader reader(queries.rays);
    for (cluster::QueryPacket packet; reader.nextPacket(packet);)
      traffic_.rays += std::popcount(packet.lanes);
  }

  void countDepths(size_t bytes) {
    const std::lock_guard lock(mutex_);
    traffic_.depthBytes += static_cast<double>(bytes);
  }

  cluster::Alone alone_;
  std::mutex mutex_;
  Traffic traffic_;
};

}  // namespace gluray::bench
