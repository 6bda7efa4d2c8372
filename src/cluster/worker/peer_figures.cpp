// PeerPrograms: what the ranks of a program spend, collected by the worker of its rank 0.
#include "base/processes/resident_memory.h"
#include "cluster/worker/peer_programs.h"

#include <utility>

namespace gluray::cluster {

void PeerPrograms::measure(Local& local) {
  const PeerTimes& times = local.exchange->times();
  const auto mean = [&](PeerTimes::Kind kind) { return times.seconds(kind) / threads_; };
  RankFigures& figures = local.figures;
  figures.eyeSeconds = mean(PeerTimes::eye), figures.lightSeconds = mean(PeerTimes::light);
  figures.scenesSeconds = times.seconds(PeerTimes::scenes);
  figures.depthsSeconds = mean(PeerTimes::depths), figures.answersSeconds = mean(PeerTimes::answers);
  figures.bytesSent = local.bytesSent, figures.memoryBytes = residentBytes();
}

void PeerPrograms::giveFigures(Local& local) {
  measure(local);
  if (local.rank == 0) return take(local, local.figures);
  if (const std::optional<int> worker = directory_.workerOf(local.program, 0))
    ranks_.send(*worker, forRanks(FiguresGiven{{local.program, local.rank, 0}, local.figures}));
}

void PeerPrograms::took(uint64_t number, double seconds) {
  Local& local = locals_.at(number);
  ++local.figures.images, local.figures.traceSeconds += seconds;
  giveFigures(local);
}

void PeerPrograms::ends(uint64_t number) {
  Local& local = locals_.at(number);
  local.figures.state = RankFigures::State::ended;
  giveFigures(local);
}

void PeerPrograms::takeFigures(const FiguresGiven& given) {
  Local* const local = find(given.address);
  if (!local) return;
  if (given.figures.rank != given.address.from) throw Malformed("the figures are of another rank");
  take(*local, given.figures);
}

void PeerPrograms::take(Local& local, const RankFigures& figures) { local.known[figures.rank] = figures; }

void PeerPrograms::setState(Local& local, int rank, RankFigures::State state) {
  if (local.rank != 0) return;
  RankFigures& known = local.known[rank];
  known.rank = rank;
  const bool hasEnded = known.state == RankFigures::State::ended;
  if (state != RankFigures::State::lost || !hasEnded) known.state = state;
}

FiguresKnown PeerPrograms::figuresFor(uint64_t number) {
  Local& local = locals_.at(number);
  measure(local);
  if (local.rank != 0) return {{local.figures}};
  take(local, local.figures);
  FiguresKnown all;
  for (const auto& [rank, figures] : local.known) all.ranks.push_back(figures);
  return all;
}

}  // namespace gluray::cluster
