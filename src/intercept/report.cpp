#include "intercept/report.h"

#include "base/clock.h"
#include "base/log.h"
#include "intercept/contexts.h"
#include "intercept/session.h"

#include <errno.h>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string>

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
      {"flushes", s.flushes},
      {"draws", {{"traced", s.drawsTraced}, {"rasterised", reasons}}},
      {"triangles", {{"traced", s.trianglesTraced}, {"rasterised", s.trianglesRasterised}}},
      {"bvh", {{"builds", s.blasBuilds}, {"bytes", s.bvhBytes}}},
      {"mesh", {{"built", s.meshesBuilt}, {"bytes", s.meshBytes}}},
      {"ms",
       {{"capture", s.captureSeconds * perFrame},
        {"build", s.buildSeconds * perFrame},
        {"trace", s.traceSeconds * perFrame},
        {"present", s.presentSeconds * perFrame}}},
      {"unknownCalls", totals.unknownCalls},
  };
}

bool launchedProcess() {
  const char* launched = std::getenv("GLURAY_PID");
  return !launched || std::to_string(getpid()) == launched;
}

/// The file that this process writes, chosen at the first report.
std::string choosePath() {
  std::string path = session().reportFile;
  if (launchedProcess()) return path;
  const int fresh = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (fresh >= 0)
    close(fresh);
  else if (errno == EEXIST)
    path.append(".").append(std::to_string(getpid()));
  return path;
}

/// Readers never see half a report: it is written beside the file and renamed.
void writeText(const std::string& text) {
  // Never destroyed: the exit handler that writes the last report was registered before this string was made.
  static const std::string& path = *new std::string(choosePath());
  const std::string draft = path + ".new";
  const int file = open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  const bool written =
      file >= 0 && write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  if (file >= 0) close(file);
  if (!written || rename(draft.c_str(), path.c_str()) != 0)
    log::once(log::Level::error, "report", "cannot write the report " + path);
}

std::mutex g_reporting;

}  // namespace

void writeReport() noexcept {
  if (isForkedChild()) return;
  try {
    const std::lock_guard lock(g_reporting);
    const Totals sum = totals();
    if (sum.contexts == 0 && !launchedProcess()) return;
    writeText(makeReport(sum).dump(2) + "\n");
  } catch (const std::exception& e) {
    log::once(log::Level::error, "report", std::string("no report: ") + e.what());
  }
}

void writeReportIfDue() noexcept {
  constexpr double kInterval = 0.1;  // seconds; a report costs about a tenth of a millisecond
  static std::atomic<double> next = 0.0;
  if (session().reportFile.empty() || nowSeconds() < next) return;
  writeReport();
  next = nowSeconds() + kInterval;
}

}  // namespace gluray::intercept
