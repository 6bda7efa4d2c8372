#include "intercept/reports/light_report.h"

#include "frame/idle/idle_refiner.h"
#include "frame/refinement/refinement_progress.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace gluray::intercept {

using nlohmann::json;

json idleReport() {
  const frame::IdleRefiner::Counts& counts = frame::IdleRefiner::counts();
  return {{"frames", counts.frames.load()},     {"refused", counts.refused.load()},
          {"finished", counts.finished.load()}, {"passes", counts.passes.load()},
          {"noise", counts.noise.load()},       {"shown", counts.shown.load()}};
}

json progressReport() {
  const std::optional<frame::RefinementProgress> now = frame::awaitedProgress();
  if (!now) return nullptr;
  return {{"share", now->share}, {"noise", now->noise}, {"secondsLeft", now->secondsLeft}};
}

}  // namespace gluray::intercept
