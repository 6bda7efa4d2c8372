#include "intercept/control/engine_program.h"

#include "base/clock.h"
#include "base/log.h"
#include "base/processes/resident_memory.h"
#include "control/process_start.h"
#include "frame/idle/idle_refiner.h"
#include "intercept/contexts/contexts.h"
#include "intercept/control/link.h"
#include "intercept/reports/light_report.h"
#include "intercept/reports/report_of_ranks.h"
#include "intercept/session/session.h"
#include "intercept/windows/window_images.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <exception>
#include <string>

namespace gluray::intercept {
namespace {

using nlohmann::json;

/// Bytes of resident memory; null: unknown.
json residentMemory() {
  const uint64_t bytes = residentBytes();
  return bytes ? json(bytes) : json();
}

json reasonsOf(const gl::Statistics& statistics) {
  json reasons = json::object();
  for (int i = 0; i < gl::kReasonCount; ++i)
    if (const uint64_t draws = statistics.rasterisedBecause[static_cast<size_t>(i)])
      reasons[std::string(describe(static_cast<gl::Reason>(i)))] = draws;
  return reasons;
}

}  // namespace

EngineProgram::EngineProgram() : name_(programName()), job_(control::jobOfThisProcess()) {}

json EngineProgram::identity() {
  char host[256] = {};
  if (gethostname(host, sizeof host - 1) != 0) host[0] = '\0';
  return {{"pid", getpid()},
          {"host", host},
          {"name", name_},
          {"rank", job_.rank},
          {"ranks", job_.ranks},
          {"job", job_.name},
          {"since", control::beginOfProcess()}};
}

control::Figures EngineProgram::figures() {
  const gl::Statistics s = totals().statistics;
  return {s.trianglesTraced, s.drawsTraced, s.drawsRasterised,
          s.drawsTraced + s.rasterisedBecause[static_cast<size_t>(gl::Reason::smallScene)]};
}

json EngineProgram::state() {
  const Totals sum = totals();
  const gl::Statistics& s = sum.statistics;
  const frame::IdleRefiner::Counts& idle = frame::IdleRefiner::counts();
  const uint64_t passes = s.lightPasses, idlePasses = idle.passes;
  if (idlePasses != idlePasses_ || passes != passes_) idle_ = idlePasses != idlePasses_;
  const double noise = idle_ ? idle.noise.load() : double{s.lightNoise};
  json done;
  if (idle_) done = idle.framePasses.load();
  passes_ = passes, idlePasses_ = idlePasses;
  return {{"reasons", reasonsOf(s)},
          {"memory", residentMemory()},
          {"ranks", observedRanks()},
          {"building", s.blasRefining != 0},
          {"noise", noise > 0 ? json(noise) : json()},
          {"passes", std::move(done)},
          {"progress", progressReport()},
          {"windows", windows()},
          {"pictures", keptImages()},
          {"opengl", {{"vendor", sum.vendor}, {"renderer", sum.renderer}, {"version", sum.version}}},
          {"warnings", log::recent()}};
}

/// Lists the windows. Queries the X server at most every two seconds, over a connection that is closed
/// afterwards, because servers have few.
json EngineProgram::windows() {
  constexpr double kEvery = 2;
  if (listed_ > 0 && nowSeconds() - listed_ < kEvery) return windows_;
  json list = json::array();
  for (const ShownWindow& window : shownWindows()) {
    const glm::ivec2 size = servers_.sizeOf(window);
    if (size == glm::ivec2(0))
      forgetShown(window);
    else
      list.push_back({{"width", size.x}, {"height", size.y}});
  }
  servers_.close();
  windows_ = list, listed_ = nowSeconds();
  return list;
}

/// Size of the window that showed a frame last.
glm::ivec2 EngineProgram::windowSize() {
  const std::vector<ShownWindow> shown = shownWindows();
  const glm::ivec2 size = shown.empty() ? glm::ivec2(0) : servers_.sizeOf(shown.front());
  servers_.close();
  return size;
}

control::Called EngineProgram::call(const std::string& name, const json& arguments, json& value,
                                    std::string& why) {
  if (SceneCalls::knows(name)) return sceneCalls_.call(name, arguments, value, why);
  why = "this program has no call '" + name + "'";
  return control::Called::done;
}

void EngineProgram::wake() noexcept {
  try {
    for (const ShownWindow& window : shownWindows()) servers_.expose(window);
    servers_.close();
  } catch (const std::exception&) {}  // out of memory: the program draws at its own time
}

void EngineProgram::tellSize(bool wider) noexcept {
  try {
    for (const ShownWindow& window : shownWindows()) servers_.tellSize(window, wider);
    servers_.close();
  } catch (const std::exception&) {}  // out of memory: the program draws at its own time
}

void EngineProgram::wantImage(control::Wanted wanted) noexcept { wantWindowImage(wanted); }

std::unique_ptr<control::KeptImage> EngineProgram::takeImage() noexcept { return takeWindowImage(); }

void EngineProgram::linkBegan(bool here) noexcept {
  if (here) leaveFile();
}

void EngineProgram::linkEnded() noexcept {
  gl::shownFrames().wantUntil(0);
  wantWindowImage(control::Wanted::none);
  takeWindowImage();
  servers_.close();
}

}  // namespace gluray::intercept
