#include "base/clock.h"
#include "base/files.h"
#include "base/log.h"
#include "gl/buffer.h"
#include "intercept/contexts.h"
#include "intercept/explanation.h"
#include "intercept/lag.h"
#include "intercept/report.h"
#include "intercept/session.h"

#include <errno.h>
#include <nlohmann/json.hpp>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace gluray::gl {

/// How the library of JSON finds the number in a counter.
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
  const double perFrame = s.frames ? 1000.0 / static_cast<double>(uint64_t{s.frames}) : 0;
  json reasons = json::object();
  for (int i = 0; i < gl::kReasonCount; ++i)
    if (s.rasterisedBecause[i])
      reasons[std::string(describe(static_cast<gl::Reason>(i)))] = s.rasterisedBecause[i];
  return {
      {"program", program_invocation_name},
      {"pid", getpid()},
      {"door", openDoorNames()},
      {"off", session().off},
      {"gl", {{"vendor", totals.vendor}, {"renderer", totals.renderer}, {"version", totals.version}}},
      {"contexts", totals.contexts},
      {"frames", s.frames},
      {"framesDirect", s.framesDirect},
      {"flushes", s.flushes},
      {"repeated", s.repeated},
      {"lag", lagReport()},
      {"draws", {{"traced", s.drawsTraced}, {"rasterised", reasons}}},
      {"triangles", {{"traced", s.trianglesTraced}, {"rasterised", s.trianglesRasterised}}},
      {"bvh", {{"builds", s.blasBuilds}, {"refined", s.blasRefinements}, {"bytes", s.bvhBytes}}},
      {"mesh", {{"built", s.meshesBuilt}, {"bytes", s.meshBytes}}},
      {"buffers", {{"bytesSent", gl::Buffer::bytesSent()}}},
      {"ms",
       {{"capture", s.captureSeconds * perFrame},
        {"build", s.buildSeconds * perFrame},
        {"trace", s.traceSeconds * perFrame},
        {"present", s.presentSeconds * perFrame}}},
      {"unknownCalls", totals.unknownCalls},
  };
}

/// Chosen at the first report.
const std::string& reportPath() {
  // Never destroyed: the exit handler that writes the last report was registered before this string was made.
  static const std::string& path = *new std::string(fileOfThisProcess(session().reportFile));
  return path;
}

void writeText(const json& report) {
  // Programs and drivers may name themselves in anything.
  const std::string text = report.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
  if (const std::string why = files::replace(reportPath(), text); !why.empty())
    log::once(log::Level::error, "report", "cannot write the report " + reportPath() + ": " + why);
}

constexpr double kInterval = 0.1;  // seconds; a report costs about a tenth of a millisecond

/// What the reporting threads share. Never destroyed: the late one may outlive the program's exit handlers.
struct Reporter {
  std::mutex mutex;
  Totals latest;      // as of the last buffer swap
  double next = 0;    // when the next report is due
  bool late = false;  // writeLate() is on its way
  bool ended = false;
  bool complete = false;  // all frames that were to be explained are there; later ones change nothing

  /// What `sum` says goes into the file. The mutex is held.
  void write(const Totals& sum) {
    if (sum.contexts != 0 || launchedProcess()) {
      json report = makeReport(sum);
      if (session().explainFrames) report["explain"] = explanation(sum, complete, reportPath());
      writeText(report);
    }
    next = nowSeconds() + kInterval;
  }
};

Reporter& reporter() {
  static auto* r = new Reporter;
  return *r;
}

/// Runs `body` with the reporter locked; a failure costs a report, nothing else.
template <class F>
void reporting(F&& body) noexcept {
  try {
    Reporter& r = reporter();
    const std::lock_guard lock(r.mutex);
    body(r);
  } catch (const std::exception& e) {
    log::once(log::Level::error, "report", std::string("no report: ") + e.what());
  }
}

/// Writes what the last swaps counted that came too soon after a report to be written at once.
void writeLate() noexcept {
  std::this_thread::sleep_for(std::chrono::duration<double>(kInterval));
  reporting([](Reporter& r) {
    r.late = false;
    if (!r.ended && !r.complete) r.write(r.latest);
  });
}

/// Starts writeLate() in a thread that the program's signal handlers never run in.
void startLate() {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  try {
    std::thread(writeLate).detach();
    reporter().late = true;
  } catch (const std::exception&) {  // the next swap tries again
  }
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace

void writeReport() noexcept {
  if (isForkedChild()) return;
  reporting([](Reporter& r) {
    r.ended = true;
    if (!r.complete) r.write(totals());
  });
}

void writeReportIfDue() noexcept {
  if (session().reportFile.empty() || isForkedChild()) return;
  reporting([](Reporter& r) {
    if (r.complete) return;
    const int wanted = session().explainFrames;
    r.complete = wanted && framesEnded() >= static_cast<uint64_t>(wanted);
    if (r.complete) closeKinds();
    r.latest = totals();
    if (r.complete || nowSeconds() >= r.next)
      r.write(r.latest);
    else if (!r.late)
      startLate();
  });
}

}  // namespace gluray::intercept
