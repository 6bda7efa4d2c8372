#include "cluster/worker/head.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace gluray::cluster {
namespace {

using Share = PartGatherer::Share;

constexpr double kAtWorkEvery = 0.2;  // seconds
constexpr size_t kMaxViews = 64;      // whose costs are remembered

}  // namespace

Head::Head(Ranks& ranks, ArrayStore& store, ArrayIntake& intake, PageMaker& pages, PeerPrograms& peers,
           JobInquiry& inquiry, int threads, size_t memory, Say say)
    : ranks_(ranks),
      store_(store),
      intake_(intake),
      pages_(pages),
      peers_(peers),
      inquiry_(inquiry),
      memory_(memory),
      say_(std::move(say)),
      states_(ranks.size(), ranks.rank(), threads) {}

bool Head::isBusy() const {
  return std::ranges::any_of(programs_,
                             [](const ConnectedProgram& p) { return p.image.has_value() || p.isWaiting(); });
}

ConnectedProgram* Head::programOf(uint64_t image) {
  const auto found = std::ranges::find_if(
      programs_, [&](const ConnectedProgram& p) { return p.image && p.image->id() == image; });
  return found == programs_.end() ? nullptr : &*found;
}

void Head::ask(ConnectedProgram& program, double now) {
  const TraceRequest& request = *program.request;
  if (request.width < 1 || request.height < 1 || request.width > 65536 || request.height > 65536)
    throw Malformed("no image has this size");
  program.paged.reset();
  if (needsPages(program)) return makePages(program, now);
  if (program.spreads) spreadAll(program);
  askNow(program, now);
}

void Head::askNow(ConnectedProgram& program, double now) {
  const TraceRequest& request = *program.request;
  if (!program.peer) return start(program, true, now);
  program.share = Share::own;
  if (!request.gathers) return start(program, true, now);
  if (!program.spreads && !program.paged) spreadAll(program);
  program.saidAtWork = now;
  peers_.gatherer(program.peer).begin(request, now);
  gather(program, now);
}

void Head::gather(ConnectedProgram& program, double now) {
  program.share = peers_.gatherer(program.peer).findShare(program.given(), now);
  if (program.share == Share::shown) return giveShown(program);
  if (!program.isGathering()) start(program, true, now);
}

TraceOrder Head::orderOf(ConnectedProgram& program, bool averages) {
  const TraceRequest& request = program.isWhole() ? program.given() : *program.request;
  TraceOrder order;
  order.id = lastImage_, order.averages = averages;
  order.shared = program.image->kind() != RequestedImage::Kind::alone;
  if (program.image->kind() == RequestedImage::Kind::moving) order.moving = movingOrderOf(program);
  order.meetsPeers = request.meetsPeers && program.share == Share::own;
  order.missColor = request.missColor;
  order.needs = program.isWhole() && program.paged ? request.arrays : program.newArrays,
  order.snapshot = request.snapshot;
  if (!program.peer || !program.isWhole()) return order;
  order.needs = request.arrays;
  for (const PartGiven& part : peers_.gatherer(program.peer).parts()) {
    order.needs.insert(order.needs.end(), part.arrays.begin(), part.arrays.end());
    order.parts.push_back(part.snapshot);
  }
  return order;
}

void Head::start(ConnectedProgram& program, bool averages, double now) {
  start(program, kindOf(program), averages, now);
}

void Head::start(ConnectedProgram& program, RequestedImage::Kind kind, bool averages, double now) {
  const TraceRequest& request = program.isWhole() ? program.given() : *program.request;
  if (program.costs.size() > kMaxViews) program.costs.clear(), program.animations.clear();
  program.image.emplace(request, ++lastImage_, averages, states_, program.costs[request.view], kind, now);
  const RequestedImage& image = *program.image;
  const TraceOrder order = orderOf(program, averages);
  // What is not here yet may be missed by the next image, too, if this one is cancelled.
  std::erase_if(program.newArrays, [&](const Hash128& name) { return holders_[name].here; });
  program.saidAtWork = now;
  if (!program.isWhole()) return peers_.trace(program.peer, order, request.shown);
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    if (!image.takesPart(rank)) continue;
    ranks_.send(rank, forRanks(order));
    states_.asked(rank, now);
  }
  giveTiles(program);
}

void Head::giveTiles(ConnectedProgram& program) {
  if (!program.isWhole()) return;
  for (int rank = 0; rank < ranks_.size(); ++rank) giveTiles(*program.image, rank);
}

void Head::giveTiles(RequestedImage& image, int rank) {
  if (!image.takesPart(rank)) return;
  const std::vector<int> tiles = image.more(rank);
  if (!tiles.empty()) ranks_.send(rank, forRanks(MoreTiles{image.id(), tiles}));
}

void Head::receive(int rank, const TracedTile& tile, double now) {
  states_.heard(rank, now);
  ConnectedProgram* const program = programOf(tile.id);
  if (!program) return;
  RequestedImage& image = *program->image;
  const bool wasTraced = image.isTraced();
  try {
    bool grew = false;
    image.addTile(rank, tile, program->memory, grew, now);
    if (grew) program->send(ImageMemory{program->memory.bytes}, program->memory.memory.get());
  } catch (const Malformed&) {
    image.drop(rank);
    return goOn(*program, now);
  }
  if (image.isSeenThrough() && image.averages()) {
    end(*program);
    return start(*program, false, now);
  }
  if (!image.isTraced()) {
    if (image.isCollected()) return goOn(*program, now);
    // The other ranks have as much as before.
    if (program->isWhole()) giveTiles(image, rank);
    return;
  }
  if (!wasTraced) end(*program);
  finish(*program, now);
}

void Head::receive(int rank, const Finished& result, double now) {
  states_.heard(rank, now);
  ConnectedProgram* const program = programOf(result.id);
  if (!program) return;
  program->image->finished(rank, result);
  if (!program->image->isTraced()) goOn(*program, now);  // it may have failed, and others have its tiles
  finish(*program, now);
}

void Head::receive(int rank, const Alive& alive, double now) {
  states_.isThere(rank, now);
  states_.setThreads(rank, std::clamp(alive.threads, 1, 1 << 16));
}

void Head::end(ConnectedProgram& program) {
  forgetVisibility(program);
  const RequestedImage& image = *program.image;
  if (!program.isWhole()) return peers_.end(program.peer, image.id());
  // Only to ranks that have it: a stopped rank would find the ends of all images made meanwhile.
  for (int rank = 0; rank < ranks_.size(); ++rank)
    if (image.asks(rank)) ranks_.send(rank, forRanks(EndOfImage{image.id()}));
}

void Head::endImage(ConnectedProgram& program, double now) {
  if (program.image) end(program);
  endPages(program);
  program.image.reset();
  if (program.isGathering()) program.share = Share::own;
  if (program.peer) peers_.gatherer(program.peer).end(false, now);
}

/// The image must be traced anew, with other parts: at the next tick.
bool Head::lacksParts(const ConnectedProgram& program) const {
  return program.isWhole() && program.peer && peers_.gatherer(program.peer).isLost();
}

void Head::finish(ConnectedProgram& program, double now) {
  const RequestedImage& image = *program.image;
  if (image.error().empty() && !image.isDone()) return;
  if (lacksParts(program)) return;
  program.costs[program.request->view] = image.costs();
  ImageDone result = image.result(now);
  if (image.hasVisibility()) {
    ConnectedProgram::Animation& animation = program.animations[program.request->view];
    ++animation.frames;
    animation.pace.took(result.cost.traceSeconds, 1 / static_cast<double>(program.request->fps));
  }
  result.gathered = program.request->gathers && result.whole && program.share != Share::own;
  if (program.request->gathers && program.share == Share::own)
    result.note = peers_.gatherer(program.peer).whyOwn();
  program.send(result);
  if (program.peer) peers_.took(program.peer, result.cost.buildSeconds + result.cost.traceSeconds);
  if (result.gathered) peers_.gatherer(program.peer).end(true, now);
  endImage(program, now);
}

void Head::tick(double now) {
  states_.tick(now);
  for (ConnectedProgram& program : programs_) {
    if (program.image && lacksParts(program)) {
      end(program);
      program.image.reset();
      program.share = Share::awaited;
    }
    if (program.isGathering()) gather(program, now);
    sayAtWork(program, now);
    if (!program.image) continue;
    RequestedImage& image = *program.image;
    bool passedOn = false;
    for (int rank = 0; rank < ranks_.size(); ++rank) {
      if (!image.takesPart(rank) || !states_.isOverdue(rank, now)) continue;
      leaveOut(rank, now);
      image.drop(rank);
      passedOn = true;
    }
    for (const int rank : image.passOnSlow(now)) leaveOut(rank, now), passedOn = true;
    if (passedOn) goOn(program, now);
    if (!image.error().empty()) finish(program, now);
  }
}

void Head::sayAtWork(ConnectedProgram& program, double now) {
  if (!(program.image || program.isWaiting()) || now - program.saidAtWork <= kAtWorkEvery) return;
  program.saidAtWork = now;
  program.send(AtWork{program.request->id});
  if (program.peer) peers_.gatherer(program.peer).atWork(now);
}

void Head::leaveOut(int rank, double now) {
  if (rank == states_.self() || states_.isLate(rank)) return;
  const double rest = states_.setLate(rank, now);
  const std::string again = rest > 0 ? "for " + std::to_string(std::lround(rest)) + " s, and " : "";
  say_("rank " + std::to_string(rank) + " does not answer; the others trace its part " + again +
       "until it does");
}

}  // namespace gluray::cluster
