#include "dist/worker/head.h"

#include "dist/messages/version.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::dist {
namespace {

constexpr double kAtWorkEvery = 0.2;  // seconds
constexpr int kCoordinator = 0;       // the rank that orders broadcasts
constexpr size_t kMostViews = 64;     // whose costs are remembered

}  // namespace

Head::Head(Ranks& ranks, ArrayStore& store, ArrayIntake& intake, PeerPrograms& peers, JobInquiry& inquiry,
           int threads, Say say)
    : ranks_(ranks),
      store_(store),
      intake_(intake),
      peers_(peers),
      inquiry_(inquiry),
      say_(std::move(say)),
      states_(ranks.size(), ranks.rank(), threads) {}

template <class M>
void Head::sendToAll(const M& message) {
  for (int rank = 0; rank < ranks_.size(); ++rank) ranks_.send(rank, forRanks(message));
}

void Head::add(control::Descriptor socket) { programs_.emplace_back(Line(std::move(socket))); }

std::vector<int> Head::descriptors() {
  std::vector<int> all;
  for (ProgramSide& program : programs_) all.push_back(program.line().descriptor());
  return all;
}

bool Head::isBusy() const {
  return std::ranges::any_of(programs_, [](const ProgramSide& p) { return p.picture.has_value(); });
}

ProgramSide* Head::programOf(uint64_t picture) {
  const auto found = std::ranges::find_if(
      programs_, [&](const ProgramSide& p) { return p.picture && p.picture->id() == picture; });
  return found == programs_.end() ? nullptr : &*found;
}

void Head::readPrograms(double now) {
  for (ProgramSide& program : programs_) {
    try {
      while (!program.isGone()) {
        const std::optional<Message> message = program.line().receive();
        if (!message) break;
        handle(program, *message, now);
      }
    } catch (const std::exception& error) {
      say_((program.name.empty() ? "a program" : program.name) + ": " + error.what() +
           "; it is disconnected");
      program.end();
    }
  }
  for (auto it = programs_.begin(); it != programs_.end();) {
    if (!it->isGone()) {
      ++it;
      continue;
    }
    leave(*it);
    it = programs_.erase(it);
  }
}

void Head::handle(ProgramSide& program, const Message& message, double now) {
  const auto as = [&]<class M>(M) { return decoded<M>(message.body); };
  if (message.type == Hello::kType) {
    if (!program.name.empty()) throw Malformed("it says hello twice");
    return greet(program, as(Hello{}));
  }
  if (program.name.empty()) throw Malformed("it says no hello");
  switch (message.type) {
    case ArrayComes::kType: return takeArray(program, as(ArrayComes{}), message.attached);
    case ArraysGo::kType: return forget(program, as(ArraysGo{}).names);
    case TraceRequest::kType:
      if (program.picture) endPicture(program);
      program.request = as(TraceRequest{});
      if (program.peer) program.request->shared = false;
      return start(program, true, now);
    case Cancel::kType:
      if (!program.picture || program.request->id != as(Cancel{}).id) return;
      endPicture(program);
      return program.send(
          PictureDone{program.request->id, false, false, "", {1, 1, 1, Image::kPicture}, {}, {}});
    case JobQuestion::kType: as(JobQuestion{}); return inquiry_.ask(program, now);
    default: throw Malformed("its kind is not known");
  }
}

void Head::greet(ProgramSide& program, const Hello& hello) {
  program.name = hello.program + " (process " + std::to_string(hello.process) + ")";
  Welcome welcome{"", ranks_.size(), states_.allThreads()};
  if (hello.version != version())
    welcome.refusal = "the worker is of GLuRay " + std::string(version()) + ", the program of " +
                      hello.version + "; use one version for both";
  if (welcome.refusal.empty() && hello.ranks > 1)
    program.peer = peers_.add(hashBytes(hello.mpiJob.data(), hello.mpiJob.size()), hello.rank, hello.ranks);
  program.send(welcome);
  say_(program.name + (welcome.refusal.empty() ? " is connected" : ": " + welcome.refusal));
  if (!welcome.refusal.empty()) program.end();
}

void Head::takeArray(ProgramSide& program, const ArrayComes& array, const control::Descriptor& memory) {
  if (program.arrays.contains(array.name)) return;
  if (!holders_.contains(array.name)) {
    // Other programs may use it by this name.
    intake_.add(++lastCheck_, array.name, mapSealed(memory, array.bytes));
    holders_[array.name].check = lastCheck_;
  }
  Holders& holders = holders_[array.name];
  ++holders.programs;
  if (!program.peer) holders.shared = true;
  spread(array.name, holders);
  program.arrays.insert(array.name);
  program.newArrays.push_back(array.name);
}

void Head::take(const ArrayChecked& checked) {
  const auto found = holders_.find(checked.name);
  if (found == holders_.end() || found->second.check != checked.number) return;  // forgotten since
  if (checked.isRight) {
    found->second.here = true;
    return spread(checked.name, found->second);
  }
  for (ProgramSide& program : programs_) {
    if (!program.arrays.contains(checked.name)) continue;
    say_(program.name + ": an array is not what its name says; it is disconnected");
    program.end();
  }
}

void Head::spread(const Hash128& name, Holders& holders) {
  if (ranks_.size() == 1 || !holders.here || !holders.shared || holders.everywhere) return;
  holders.everywhere = true;
  const Array array = store_.find(name);
  store_.put(ranks_.rank(), name, array);  // until it has been broadcast
  ranks_.send(kCoordinator, forRanks(TurnWanted{name, array.bytes.size()}));
}

void Head::forget(ProgramSide& program, const std::vector<Hash128>& names) {
  Forget all, here;
  for (const Hash128& name : names) {
    if (program.arrays.erase(name) == 0) continue;
    Holders& holders = holders_[name];
    if (--holders.programs > 0) continue;
    (holders.everywhere ? all : here).names.push_back(name);
    holders_.erase(name);
  }
  std::erase_if(program.newArrays, [&](const Hash128& name) { return !program.arrays.contains(name); });
  if (!all.names.empty()) sendToAll(all);
  if (!here.names.empty()) store_.forget(ranks_.rank(), here.names);
}

void Head::start(ProgramSide& program, bool averages, double now) {
  const TraceRequest& request = *program.request;
  if (request.width < 1 || request.height < 1 || request.width > 65536 || request.height > 65536)
    throw Malformed("no picture has this size");
  if (program.costs.size() > kMostViews) program.costs.clear();
  program.picture.emplace(request, ++lastPicture_, averages, states_, program.costs[request.view], now);
  const Picture& picture = *program.picture;
  const TraceOrder order{picture.id(),      request.shared,    averages,        request.meetsPeers,
                         request.missColor, program.newArrays, request.snapshot};
  // What is not here yet may be missed by the next picture, too, if this one is cancelled.
  std::erase_if(program.newArrays, [&](const Hash128& name) { return holders_[name].here; });
  program.saidAtWork = now;
  if (program.peer) return peers_.trace(program.peer, order, request.shown);
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    if (!picture.takesPart(rank)) continue;
    ranks_.send(rank, forRanks(order));
    states_.asked(rank, now);
  }
  giveTiles(program);
}

void Head::giveTiles(ProgramSide& program) {
  if (program.peer) return;
  for (int rank = 0; rank < ranks_.size(); ++rank) giveTiles(*program.picture, rank);
}

void Head::giveTiles(Picture& picture, int rank) {
  if (!picture.takesPart(rank)) return;
  const std::vector<int> tiles = picture.more(rank);
  if (!tiles.empty()) ranks_.send(rank, forRanks(MoreTiles{picture.id(), tiles}));
}

void Head::take(int rank, const TracedTile& tile, double now) {
  states_.heard(rank, now);
  ProgramSide* const program = programOf(tile.id);
  if (!program) return;
  Picture& picture = *program->picture;
  const bool wasTraced = picture.isTraced();
  try {
    bool grew = false;
    picture.take(rank, tile, program->memory, grew, now);
    if (grew) program->send(PictureMemory{program->memory.bytes}, program->memory.memory.get());
  } catch (const Malformed&) {
    picture.drop(rank);
    giveTiles(*program);
  }
  if (picture.isSeenThrough() && picture.averages()) {
    endPicture(*program);
    return start(*program, false, now);
  }
  if (!picture.isTraced()) {
    // The other ranks have as much as before.
    if (!program->peer) giveTiles(picture, rank);
    return;
  }
  if (!wasTraced) end(*program);
  finish(*program, now);
}

void Head::take(int rank, const Finished& result, double now) {
  states_.heard(rank, now);
  ProgramSide* const program = programOf(result.id);
  if (!program) return;
  program->picture->finished(rank, result);
  if (!program->picture->isTraced()) giveTiles(*program);  // it may have failed, and others have its tiles
  finish(*program, now);
}

void Head::take(int rank, const Alive& alive, double now) {
  states_.isThere(rank, now);
  states_.setThreads(rank, std::clamp(alive.threads, 1, 1 << 16));
}

void Head::end(ProgramSide& program) {
  const Picture& picture = *program.picture;
  if (program.peer) return peers_.end(program.peer, picture.id());
  // Only to ranks that have it: a stopped rank would find the ends of all pictures made meanwhile.
  for (int rank = 0; rank < ranks_.size(); ++rank)
    if (picture.asks(rank)) ranks_.send(rank, forRanks(EndOfPicture{picture.id()}));
}

void Head::endPicture(ProgramSide& program) {
  end(program);
  program.picture.reset();
}

void Head::finish(ProgramSide& program, double now) {
  const Picture& picture = *program.picture;
  if (picture.error().empty() && !picture.isDone()) return;
  program.costs[program.request->view] = picture.costs();
  program.send(picture.result(now));
  endPicture(program);
}

void Head::tick(double now) {
  for (ProgramSide& program : programs_) {
    if (!program.picture) continue;
    Picture& picture = *program.picture;
    bool passedOn = false;
    for (int rank = 0; rank < ranks_.size(); ++rank) {
      if (!picture.takesPart(rank) || !states_.isOverdue(rank, now)) continue;
      leaveOut(rank);
      picture.drop(rank);
      passedOn = true;
    }
    for (const int rank : picture.passOnSlow(now)) leaveOut(rank), passedOn = true;
    if (passedOn) giveTiles(program);
    if (now - program.saidAtWork > kAtWorkEvery) {
      program.saidAtWork = now;
      program.send(AtWork{program.request->id});
    }
    if (!picture.error().empty()) finish(program, now);
  }
}

void Head::leaveOut(int rank) {
  if (rank == states_.self() || states_.isLate(rank)) return;
  states_.setLate(rank);
  say_("rank " + std::to_string(rank) + " does not answer; the others trace its part until it does");
}

void Head::leave(ProgramSide& program) {
  if (program.picture) endPicture(program);
  if (program.peer) peers_.remove(program.peer);
  inquiry_.forget(program);
  forget(program, {program.arrays.begin(), program.arrays.end()});
  if (!program.name.empty()) say_(program.name + " is gone");
}

}  // namespace gluray::dist
