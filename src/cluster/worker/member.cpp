#include "cluster/worker/member.h"

namespace gluray::cluster {
namespace {

constexpr double kAliveEvery = 0.2;                // seconds
constexpr uint64_t kMaxBytes = uint64_t{1} << 46;  // of an array

}  // namespace

Member::Member(Ranks& ranks, ArrayStore& store, Outbox& outbox, PageStore& pages, int threads)
    : ranks_(ranks),
      store_(store),
      outbox_(outbox),
      pages_(pages),
      threads_(threads),
      tracing_(store, outbox, threads, nullptr, &pages) {}

Member::~Member() {
  for (auto& [key, queue] : queues_) queue->close();
  store_.wake(), pages_.wake();
}

void Member::receive(int head, TraceOrder order, double now) {
  const Key key{head, order.id};
  auto queue = std::make_shared<TileQueue>(head, order.id, outbox_);
  queues_[key] = queue;
  tracing_.add({head, std::move(order), std::move(queue)});
  ranks_.send(head, forRanks(Alive{threads_}));
  saidAlive_ = now;
}

void Member::receive(int head, const MoreTiles& tiles) {
  if (const auto found = queues_.find({head, tiles.id}); found != queues_.end())
    found->second->add(tiles.tiles);
}

void Member::receive(int head, VisibilityReady visibility) {
  if (const auto found = queues_.find({head, visibility.id}); found != queues_.end())
    found->second->setVisibility(std::move(visibility));
}

void Member::receive(int head, const EndOfImage& end) {
  const auto found = queues_.find({head, end.id});
  if (found == queues_.end()) return;
  found->second->close();
  queues_.erase(found);
  store_.wake(), pages_.wake();
}

void Member::receive(int head, const Forget& forget) { store_.forget(head, forget.names); }

void Member::receive(int root, const TurnWanted& wanted) {
  for (int rank = 0; rank < ranks_.size(); ++rank)
    ranks_.send(rank, forRanks(Turn{root, wanted.name, wanted.bytes}));
}

void Member::receive(const Turn& turn) {
  if (turn.bytes > kMaxBytes || turn.root < 0 || turn.root >= ranks_.size()) throw Malformed("no such array");
  if (turn.root == ranks_.rank()) {
    const Array array = store_.find(turn.name);
    if (!array.owner || array.bytes.size() != turn.bytes) throw Malformed("no such array");
    ranks_.broadcast(turn.root, {const_cast<std::byte*>(array.bytes.data()), array.bytes.size()},
                     [this, array, turn] { store_.forget(turn.root, {turn.name}); });
    return;
  }
  const ArrayRoom room = arrayRoom(turn.bytes);
  ++incoming_[turn.root];
  ranks_.broadcast(turn.root, room.content(), [this, room, turn] {
    store_.put(turn.root, turn.name, room.array());
    // A head leaves ranks out that wait for geometry for long.
    if (--incoming_[turn.root] == 0) ranks_.send(turn.root, forRanks(CaughtUp{}));
  });
}

void Member::tick(double now) {
  if (queues_.empty() || now - saidAlive_ < kAliveEvery) return;
  saidAlive_ = now;
  int last = -1;
  for (const auto& [key, queue] : queues_)
    if (key.first != last) ranks_.send(last = key.first, forRanks(Alive{threads_}));
}

}  // namespace gluray::cluster
