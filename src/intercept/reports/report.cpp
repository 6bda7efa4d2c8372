#include "intercept/reports/report.h"

#include "base/clock.h"
#include "base/files.h"
#include "base/log.h"
#include "base/never_destroyed.h"
#include "base/processes/own_thread.h"
#include "frame/idle/idle_refiner.h"
#include "frame/refinement/refinement_progress.h"
#include "gl/buffers/buffer.h"
#include "intercept/contexts/contexts.h"
#include "intercept/contexts/frame_count.h"
#include "intercept/reports/explanation.h"
#include "intercept/reports/light_report.h"
#include "intercept/reports/report_file.h"
#include "intercept/reports/report_of_ranks.h"
#include "intercept/session/guarded.h"
#include "intercept/session/session.h"
#include "intercept/window_systems/bypassed_doors.h"
#include "intercept/windows/lag.h"

#include <errno.h>
#include <nlohmann/json.hpp>
#include <pthread.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace gluray::gl {

/// Conversion for the JSON library.
template <class T>
void to_json(nlohmann::json& json, const Counter<T>& counter) {
  json = T{counter};
}

}  // namespace gluray::gl

namespace gluray::intercept {
namespace {

using nlohmann::json;

json lagReport() {
  const LagCounts counts = lagCounts();
  json because = json::object();
  for (int i = 1; i < gl::kLagRefusals; ++i)
    if (const uint64_t frames = counts.because[static_cast<size_t>(i)])
      because[std::string(gl::describe(static_cast<gl::LagRefusal>(i)))] = frames;
  return {{"on", session().lag != LagMode::off},
          {"later", counts.later},
          {"shownByUs", counts.shownByUs},
          {"atOnce", because}};
}

json makeReport(const Totals& totals) {
  const gl::Statistics& s = totals.statistics;
  const uint64_t frames = s.frames + s.framesInFront + s.framesInMemory;
  const double perFrame = frames ? 1000.0 / static_cast<double>(frames) : 0;
  json reasons = json::object();
  for (int i = 0; i < gl::kReasonCount; ++i)
    if (s.rasterisedBecause[i])
      reasons[std::string(describe(static_cast<gl::Reason>(i)))] = s.rasterisedBecause[i];
  return {
      {"program", program_invocation_name},
      {"pid", getpid()},
      {"door", openDoorNames()},
      {"off", session().off},
      {"gl",
       {{"vendor", totals.vendor},
        {"renderer", totals.renderer},
        {"version", totals.version},
        {"software", gl::isSoftwareRenderer(totals.renderer)}}},
      {"contexts", totals.contexts},
      {"frames", frames},
      {"framesDirect", s.framesPassedThrough},
      {"flushes", s.flushes},
      {"repeated", s.repeated},
      {"lag", lagReport()},
      {"draws", {{"traced", s.drawsTraced}, {"rasterised", reasons}}},
      {"triangles", {{"traced", s.trianglesTraced}, {"rasterised", s.trianglesRasterised}}},
      {"lit", {{"draws", s.drawsLit}, {"imagesAgain", s.imagesRelit}}},
      {"culled", {{"draws", s.drawsCulled}, {"trianglesLeftOut", s.trianglesLeftOut}}},
      {"bvh", {{"builds", s.blasBuilds}, {"refined", s.blasRefinements}, {"bytes", s.bvhBytes}}},
      {"light",
       {{"passes", s.lightPasses},
        {"noise", s.lightNoise},
        {"idle", idleReport()},
        {"progress", progressReport()}}},
      {"mesh", {{"built", s.meshesBuilt}, {"bytes", s.meshBytes}}},
      {"buffers", {{"bytesSent", gl::Buffer::bytesSent()}}},
      {"ms",
       {{"capture", s.captureSeconds * perFrame},
        {"build", s.buildSeconds * perFrame},
        {"trace", s.traceSeconds * perFrame},
        {"present", s.presentSeconds * perFrame}}},
      {"unknownCalls", totals.unknownCalls},
      {"warnings", log::recent()},
  };
}

constexpr double kInterval = 0.1;  // seconds; a report costs about a tenth of a millisecond
constexpr double kQuiet = 1;       // seconds without a frame after which draws alone cause a report
constexpr int kAtOnce = 32;        // first frames that are written at once: a signal may end short programs

using Progress = std::array<uint64_t, 7>;

/// The statistics whose change causes a new report.
Progress progress(const Totals& sum) {
  const gl::Statistics& s = sum.statistics;
  const frame::IdleRefiner::Counts& idle = frame::IdleRefiner::counts();
  const std::optional<frame::RefinementProgress> awaited = frame::awaitedProgress();
  return Progress{static_cast<uint64_t>(sum.contexts),
                  s.frames,
                  s.flushes,
                  s.drawsTraced,
                  s.drawsRasterised,
                  idle.passes.load() + idle.finished.load(),
                  awaited ? 1 + static_cast<uint64_t>(1000 * awaited->share) : 0};
}

/// State shared by the program's threads, the watcher and the exit handler. Never destroyed: the watcher may
/// outlive the exit handlers.
struct Reporter {
  std::mutex mutex;
  Totals latest;           // as of the last frame
  std::string walkedPast;  // as of the last frame
  bool waiting = false;    // `latest` is not in the file yet
  Progress written{};
  double next = 0, lastFrame = 0;  // times of the next report and of the last frame's end
  int atOnce = kAtOnce;
  bool watched = false;
  bool ended = false;
  bool complete = false;  // all frames to be explained are recorded; later ones change nothing

  /// Writes `sum` to the file. Requires the mutex.
  void write(const Totals& sum) {
    if ((sum.contexts != 0 || launchedProcess()) && !isReportedByRankZero()) {
      json report = makeReport(sum);
      report["walkedPast"] = walkedPast;
      if (const json ranks = reportOfRanks(ended); !ranks.is_null()) report.update(ranks);
      if (session().explainFrames) report["explain"] = explanation(sum, complete, reportPath());
      writeReportText(report);
    }
    waiting = false;
    written = progress(sum);
    next = nowSeconds() + kInterval;
  }
};

Reporter& reporter() {
  static NeverDestroyed<Reporter> reporter;
  return *reporter;
}

/// Locks with a time limit, because a signal handler may have called exit() in the middle of a report.
bool lockInTime(std::mutex& mutex) {
  constexpr int kPatience = 1000;  // milliseconds
  for (int i = 0; i < kPatience; ++i) {
    if (mutex.try_lock()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

/// Runs `body` with the reporter locked. If it throws, only this report is lost.
template <class F>
void reporting(F&& body, bool atExit = false) noexcept {
  try {
    Reporter& r = reporter();
    if (!atExit)
      r.mutex.lock();
    else if (!lockInTime(r.mutex))
      return;
    const std::lock_guard lock(r.mutex, std::adopt_lock);
    body(r);
  } catch (const std::exception& e) {
    log::once(log::Level::error, "report", std::string("no report: ") + e.what());
  }
}

/// Whether reports are written while the program runs. A report to a stream is written only at exit.
bool writesMeanwhile() {
  const std::string& file = session().reportFile;
  return !file.empty() && !files::isStream(file) && !isForkedChild();
}

/// Writes the statistics of frames that ended too soon after a report, and of programs that end no frames.
void lookAfter(Reporter& r) {
  if (r.waiting) return r.write(r.latest);
  if (nowSeconds() < r.lastFrame + kQuiet) return;
  const Totals now = totals();
  if (progress(now) != r.written) r.write(now);
}

/// Runs until the exit handlers run, or until all frames to be explained are recorded.
void watch() noexcept {
  for (bool goOn = true; goOn;) {
    std::this_thread::sleep_for(std::chrono::duration<double>(kInterval));
    reporting([&](Reporter& r) {
      goOn = !r.ended && !r.complete;
      if (goOn) lookAfter(r);
    });
  }
}

/// Starts watch() on a thread. If that fails, the next frame tries again. Requires the mutex.
void startWatching(Reporter& r) {
  if (r.watched) return;
  pthread_t thread;
  r.watched = startThread(
      thread,
      [](void*) -> void* {
        watch();
        return nullptr;
      },
      nullptr);
  if (r.watched) pthread_detach(thread);
}

/// walkedPast() for the report. Call it before locking the reporter: it takes the dynamic linker's lock,
/// which a thread that loads a library may hold while it waits for the reporter.
std::string walkedPastNow() noexcept {
  try {
    return walkedPast();
  } catch (const std::exception&) { return {}; }  // out of memory: the next report contains it
}

}  // namespace

json reportOfNow() {
  json report = makeReport(totals());
  report["walkedPast"] = walkedPastNow();
  return report;
}

void writeReport() noexcept {
  if (isForkedChild()) return;
  const std::string past = walkedPastNow();
  reporting(
      [&](Reporter& r) {
        r.ended = true;
        if (r.complete) return;
        r.walkedPast = past;
        r.write(totals());
        sayEndToRankZero();
      },
      /*atExit=*/true);
}

void watchForReport() noexcept {
  if (!writesMeanwhile()) return;
  const std::string past = walkedPastNow();
  reporting([&](Reporter& r) {
    r.walkedPast = past;
    startWatching(r);
  });
}

void writeReportIfDue() noexcept {
  if (!writesMeanwhile()) return;
  const std::string past = walkedPastNow();
  reporting([&](Reporter& r) {
    if (r.complete) return;
    const int wanted = session().explainFrames;
    r.complete = wanted && framesEnded() >= static_cast<uint64_t>(wanted);
    if (r.complete) closeKinds();
    r.latest = totals();
    r.lastFrame = nowSeconds();
    const bool now = r.complete || r.lastFrame >= r.next || r.atOnce > 0;
    r.walkedPast = past;
    r.waiting = true;
    if (now) r.write(r.latest);
    if (r.atOnce > 0) --r.atOnce;
    startWatching(r);
  });
}

}  // namespace gluray::intercept
