#include "frame/refinement/refinement_progress.h"

#include "base/clock.h"
#include "base/log.h"
#include "base/never_destroyed.h"
#include "frame/refinement/refiner.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <mutex>

namespace gluray::frame {
namespace {

struct Awaited {
  std::mutex mutex;
  const void* teller = nullptr;  // whose progress it is; null: nobody's
  RefinementProgress progress;
};

Awaited& awaited() {
  static NeverDestroyed<Awaited> awaited;
  return *awaited;
}

std::string timeText(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(std::clamp(seconds, 0.0, 1e9)));
  if (whole < 60) return std::to_string(whole) + " s";
  const std::string minutes = std::to_string(whole / 60 % 60) + " min";
  return whole < 3600 ? minutes : std::to_string(whole / 3600) + " h " + minutes;
}

}  // namespace

RefinementProgress progressOf(const Refinement& refinement, const Settings& settings) {
  RefinementProgress progress;
  progress.noise = refinement.noise();
  const double done = refinement.passes();
  double needed = settings.refine.passes;
  if (std::isfinite(progress.noise)) {
    const double ratio = progress.noise / std::max(double{settings.noise}, 1e-9);
    needed = std::min(needed, std::max(double{kMinPasses}, done * ratio * ratio));
  }
  progress.share = done / std::max(needed, done);
  if (settings.refine.seconds > 0)
    progress.share = std::max(progress.share, refinement.seconds() / double{settings.refine.seconds});
  progress.share = std::clamp(progress.share, 0.0, 1.0);
  progress.secondsLeft = progress.share > 0 ? refinement.seconds() * (1 / progress.share - 1)
                                            : std::numeric_limits<double>::infinity();
  return progress;
}

std::string progressLine(const RefinementProgress& progress, const Settings& settings) {
  char text[120];
  const int percent = static_cast<int>(100 * progress.share);
  if (std::isfinite(progress.noise))
    std::snprintf(text, sizeof text, "gluray: refining the image: %d %%, noise %.4f of %.4f, ", percent,
                  progress.noise, double{settings.noise});
  else
    std::snprintf(text, sizeof text, "gluray: refining the image: %d %%, ", percent);
  const bool known = std::isfinite(progress.secondsLeft);
  return text + (known ? timeText(progress.secondsLeft) + " left" : "first pass");
}

std::optional<RefinementProgress> awaitedProgress() noexcept {
  Awaited& now = awaited();
  const std::lock_guard lock(now.mutex);
  if (!now.teller) return std::nullopt;
  return now.progress;
}

ProgressTeller::ProgressTeller(const Settings& settings) : settings_(settings), next_(nowSeconds() + kLong) {}

ProgressTeller::~ProgressTeller() {
  if (!tells_) return;
  log::status("");
  Awaited& now = awaited();
  const std::lock_guard lock(now.mutex);
  if (now.teller == this) now.teller = nullptr;
}

void ProgressTeller::passed(const Refinement& refinement) noexcept {
  try {
    const double now = nowSeconds();
    if (now < next_) return;
    next_ = now + kEvery;
    const RefinementProgress progress = progressOf(refinement, settings_);
    {
      Awaited& shared = awaited();
      const std::lock_guard lock(shared.mutex);
      shared.teller = this, shared.progress = progress;
    }
    tells_ = true;
    if (settings_.refine.progress) log::status(progressLine(progress, settings_));
  } catch (const std::exception&) {}  // out of memory: nothing is told
}

}  // namespace gluray::frame
