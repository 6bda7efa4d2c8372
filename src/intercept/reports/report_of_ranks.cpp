#include "intercept/reports/report_of_ranks.h"

#include "base/clock.h"
#include "base/never_destroyed.h"
#include "cluster/program/frame_limit.h"
#include "intercept/session/session.h"
#include "intercept/tracing/workers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

namespace gluray::intercept {
namespace {

using cluster::RankFigures;
using nlohmann::json;

constexpr int kMeanwhileMs = 10, kAtEndMs = 300;
constexpr double kOthersEnd = 0.5;  // seconds that rank 0 waits for the ends of others

/// The workers of an MPI program; null: the process traces its images itself, or is no rank.
cluster::RemoteTracer* workersOfRanks() {
  return jobOfReport().ranks > 1 && !session().workers.empty() ? workers() : nullptr;
}

const char* describe(RankFigures::State state) {
  switch (state) {
    case RankFigures::State::connected: return "connected";
    case RankFigures::State::ended: return "ended";
    case RankFigures::State::lost: return "lost";
  }
  return "";
}

json rowOf(const RankFigures& r) {
  const double perImage = r.images ? 1000.0 / static_cast<double>(r.images) : 0;
  return {{"rank", r.rank},
          {"state", describe(r.state)},
          {"host", r.host},
          {"images", r.images},
          {"ms",
           {{"image", r.traceSeconds * perImage},
            {"eye", r.eyeSeconds * perImage},
            {"light", r.lightSeconds * perImage},
            {"waiting",
             {{"scenes", r.scenesSeconds * perImage},
              {"depths", r.depthsSeconds * perImage},
              {"answers", r.answersSeconds * perImage}}}}},
          {"bytes", {{"sent", r.bytesSent}, {"received", r.bytesReceived}}},
          {"memory", r.memoryBytes}};
}

json rowsOf(const std::vector<RankFigures>& figures, int ranks) {
  json rows = json::array();
  for (int rank = 0; rank < ranks; ++rank) {
    const auto found = std::ranges::find(figures, rank, &RankFigures::rank);
    rows.push_back(found == figures.end() ? json{{"rank", rank}, {"state", "never connected"}}
                                          : rowOf(*found));
  }
  return rows;
}

bool hasOpen(const std::vector<RankFigures>& ranks) {
  return std::ranges::any_of(
      ranks, [](const RankFigures& r) { return r.rank != 0 && r.state == RankFigures::State::connected; });
}

/// As last known if the workers do not answer now.
const std::vector<RankFigures>& figuresOfRanks(cluster::RemoteTracer& workers, bool atEnd) {
  static NeverDestroyed<std::vector<RankFigures>> known;  // guarded by the reporter
  const double end = nowSeconds() + kOthersEnd;
  for (;;) {
    std::vector<RankFigures> now = workers.figures(atEnd ? kAtEndMs : kMeanwhileMs);
    const bool goOn = atEnd && hasOpen(now) && nowSeconds() < end;
    if (!now.empty()) *known = std::move(now);
    if (!goOn) return *known;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace

const control::Job& jobOfReport() {
  static const control::Job& job =
      *new control::Job(session().explainFrames ? control::Job{} : control::jobOfThisProcess());
  return job;
}

bool isReportedByRankZero() noexcept {
  try {
    if (jobOfReport().rank == 0) return false;
    const cluster::RemoteTracer* const tracer = workersOfRanks();
    return tracer && tracer->reach() != cluster::RemoteTracer::Reach::alone;
  } catch (const std::exception&) { return false; }  // out of memory
}

json observedRanks() {
  const control::Job& job = jobOfReport();
  cluster::RemoteTracer* const tracer = job.rank == 0 ? workersOfRanks() : nullptr;
  return tracer ? rowsOf(tracer->observedFigures(), job.ranks) : json();
}

json reportOfRanks(bool atEnd) {
  const control::Job& job = jobOfReport();
  cluster::RemoteTracer* const tracer = workersOfRanks();
  if (!tracer || job.rank != 0) return {};
  const std::vector<RankFigures>& figures = figuresOfRanks(*tracer, atEnd);
  return {{"ranks", rowsOf(figures, job.ranks)},
          {"workers", tracer->reach() == cluster::RemoteTracer::Reach::alone ? "do not answer" : "answer"},
          {"limit", cluster::limitOf(figures)}};
}

void sayEndToRankZero() noexcept {
  try {
    if (jobOfReport().rank == 0) return;
    if (cluster::RemoteTracer* const tracer = workersOfRanks()) tracer->sayEnd(kAtEndMs);
  } catch (const std::exception&) {}  // out of memory: rank 0 says that this rank is lost
}

}  // namespace gluray::intercept
