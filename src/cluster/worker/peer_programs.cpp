#include "cluster/worker/peer_programs.h"

#include "cluster/worker/facts/rank_facts.h"

#include <utility>

namespace gluray::cluster {
namespace {

constexpr int kMaxRanks = 1 << 16;  // of a program

}  // namespace

PeerPrograms::PeerPrograms(Ranks& ranks, ArrayStore& store, Outbox& outbox, int threads, Say say)
    : ranks_(ranks), store_(store), outbox_(outbox), threads_(threads), say_(std::move(say)) {}

PeerPrograms::~PeerPrograms() {
  while (!locals_.empty()) remove(locals_.begin()->first);
}

uint64_t PeerPrograms::add(const Hash128& program, int rank, int ranks) {
  if (ranks < 2 || ranks > kMaxRanks || rank < 0 || rank >= ranks)
    throw Malformed("it is no rank of a program");
  Local& local = locals_[++last_];
  local.program = program, local.rank = rank, local.ranks = ranks;
  local.figures.rank = rank, local.figures.host = hostName();
  const auto send = [this, program, &local](int peer, std::vector<std::byte> message) {
    const std::optional<int> worker = directory_.workerOf(program, peer);
    if (!worker) return;
    local.bytesSent.fetch_add(message.size(), std::memory_order_relaxed);
    outbox_.push(*worker, std::move(message));
  };
  local.exchange = std::make_unique<PeerExchange>(program, rank, ranks, send, say_);
  local.gatherer = std::make_unique<PartGatherer>(program, rank, ranks, send, say_);
  local.thread = std::make_unique<TracingThread>(store_, outbox_, threads_, local.exchange.get());
  tellAll(local, true);
  return last_;
}

void PeerPrograms::remove(uint64_t number) {
  const auto found = locals_.find(number);
  if (found == locals_.end()) return;
  Local& local = found->second;
  tellAll(local, false);
  if (local.tiles) local.tiles->close();
  local.exchange->close();
  store_.wake();
  local.thread.reset();
  locals_.erase(found);
}

void PeerPrograms::tellAll(const Local& local, bool here) {
  const PeerAddress address{local.program, local.rank, local.rank};
  for (int rank = 0; rank < ranks_.size(); ++rank)
    ranks_.send(rank, here ? forRanks(PeerJoins{address}) : forRanks(PeerLeaves{address}));
}

void PeerPrograms::trace(uint64_t number, TraceOrder order, const ViewName& shown) {
  Local& local = locals_.at(number);
  local.image = order.id;
  local.tiles = std::make_shared<TileQueue>(ranks_.rank(), order.id, outbox_);
  local.exchange->announce(order.meetsPeers ? std::optional(shown) : std::nullopt);
  local.thread->add({ranks_.rank(), std::move(order), local.tiles});
}

void PeerPrograms::end(uint64_t number, uint64_t image) {
  const auto found = locals_.find(number);
  if (found == locals_.end() || found->second.image != image) return;
  Local& local = found->second;
  local.image = 0;
  std::exchange(local.tiles, nullptr)->close();
  local.exchange->cancel();
  store_.wake();
}

PeerPrograms::Local* PeerPrograms::find(const PeerAddress& address) {
  for (auto& [number, local] : locals_) {
    if (local.program != address.program || local.rank != address.to) continue;
    if (address.from < 0 || address.from >= local.ranks || address.from == local.rank)
      throw Malformed("the program has no such rank");
    return &local;
  }
  return nullptr;
}

void PeerPrograms::joins(int from, const PeerAddress& address) {
  if (address.from < 0 || address.from >= kMaxRanks) throw Malformed("the program has no such rank");
  if (!directory_.add(address.program, address.from, from)) return;
  for (auto& [number, local] : locals_) {
    if (local.program != address.program || local.rank == address.from) continue;
    if (address.from >= local.ranks) throw Malformed("the program has no such rank");
    setState(local, address.from, RankFigures::State::connected);
    local.exchange->joins(address.from);
    local.gatherer->joins(address.from);
    // It may have come after this one had told all.
    if (from != ranks_.rank())
      ranks_.send(from, forRanks(PeerJoins{{local.program, local.rank, local.rank}}));
  }
}

void PeerPrograms::leaves(int from, const PeerAddress& address, double now) {
  if (directory_.workerOf(address.program, address.from) != from) return;
  directory_.remove(address.program, address.from);
  for (auto& [number, local] : locals_)
    if (local.program == address.program && local.rank != address.from && address.from < local.ranks)
      local.exchange->leaves(address.from), local.gatherer->leaves(address.from, now),
          setState(local, address.from, RankFigures::State::lost);
}

bool PeerPrograms::receive(int from, uint16_t type, std::span<const std::byte> body, double now) {
  const auto to = [&]<class M>(auto Local::*receiver, M message) {
    message = decoded<M>(body);
    Local* const local = find(message.address);
    if (!local) return true;
    local->figures.bytesReceived += body.size();
    (local->*receiver)->receive(std::move(message), now);
    return true;
  };
  switch (type) {
    case PeerJoins::kType: return joins(from, decoded<PeerJoins>(body).address), true;
    case PeerLeaves::kType: return leaves(from, decoded<PeerLeaves>(body).address, now), true;
    case FiguresGiven::kType: return takeFigures(decoded<FiguresGiven>(body)), true;
    case SceneComes::kType: return to(&Local::exchange, SceneComes{});
    case SceneHeld::kType: return to(&Local::exchange, SceneHeld{});
    case OcclusionQueries::kType: return to(&Local::exchange, OcclusionQueries{});
    case OcclusionReplies::kType: return to(&Local::exchange, OcclusionReplies{});
    case TileDepths::kType: return to(&Local::exchange, TileDepths{});
    case NoDepths::kType: return to(&Local::exchange, NoDepths{});
    case DoneAsking::kType: return to(&Local::exchange, DoneAsking{});
    case StillHere::kType: return to(&Local::exchange, StillHere{});
    case PartHere::kType: return to(&Local::gatherer, PartHere{});
    case PartOver::kType: return to(&Local::gatherer, PartOver{});
    case PartComes::kType: return to(&Local::gatherer, PartComes{});
    case PartGiven::kType: return to(&Local::gatherer, PartGiven{});
    case PartDone::kType: return to(&Local::gatherer, PartDone{});
    case PartImage::kType: return to(&Local::gatherer, PartImage{});
    case PartGone::kType: return to(&Local::gatherer, PartGone{});
    case PartAtWork::kType: return to(&Local::gatherer, PartAtWork{});
    default: return false;
  }
}

void PeerPrograms::tick(double now) {
  for (auto& [number, local] : locals_) local.exchange->tick(now), local.gatherer->tick(now);
}

bool PeerPrograms::isBusy() const {
  for (const auto& [number, local] : locals_)
    if (local.image != 0) return true;
  return false;
}

}  // namespace gluray::cluster
