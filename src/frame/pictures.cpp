#include "frame/pictures.h"

#include "base/clock.h"
#include "base/log.h"

#include <exception>
#include <utility>

namespace gluray::frame {
namespace {

constexpr double kRedrawSeconds = 1.0 / 20;  // for passes when a program draws the same frame again

void logFailure(const std::string& why) {
  log::once(log::Level::warning, "refinement", "cannot refine a picture: " + why + "; it keeps its noise");
}

/// Traces passes until the picture is finished or, unless it must be, the time is up. False: a pass failed.
bool tracePasses(Refiner& refiner, const Trace& trace, uint32_t missColor, bool finish,
                 Pictures::Result& result) {
  const double start = nowSeconds();
  double now = start, last = 0;
  while (!refiner.finished() && (finish || result.passes == 0 || now + last < start + kRedrawSeconds)) {
    if (!refiner.pass(trace, missColor, result.cost, result.why)) return false;
    ++result.passes;
    last = nowSeconds() - now, now += last;
  }
  return true;
}

}  // namespace

/// Traces all passes of a new picture. False: not even the first one was possible.
bool Pictures::finish(const scene::Snapshot& snapshot, LastPictures::Picture& picture,
                      Result& result) noexcept {
  try {
    Refinement refinement;
    Refiner refiner(snapshot, refinement);
    const bool all = tracePasses(refiner, trace_, picture.image.missColor, true, result);
    if (!all) logFailure(std::exchange(result.why, {}));
    if (refinement.passes() == 0) return false;
    refiner.show(picture.image);
    result.noise = refinement.noise();
    return picture.refined = true;
  } catch (const std::exception& e) { return logFailure(e.what()), false; }
}

/// Adds passes to a known picture. Whatever fails, the picture stays as good as it was.
void Pictures::refine(const scene::Snapshot& snapshot, LastPictures::Picture& picture, bool finish,
                      Result& result) noexcept {
  try {
    auto passes = std::exchange(picture.refinement, nullptr);
    if (!passes) passes = std::make_unique<Refinement>();
    Refiner refiner(snapshot, *passes);
    const bool all = tracePasses(refiner, trace_, picture.image.missColor, finish, result);
    if (!all) logFailure(std::exchange(result.why, {}));
    // Fewer passes may be worse than the first picture, which may have been filtered.
    if (result.passes > 0 && (refiner.finished() || passes->passes() >= kLeastPasses)) {
      last_.renew(picture);
      refiner.show(picture.image);
      result.repeated = false;
      result.noise = passes->noise();
    }
    picture.refined = refiner.finished() || !all;
    if (!picture.refined) picture.refinement = std::move(passes);
  } catch (const std::exception& e) {
    logFailure(e.what());
    picture.refined = true;
  }
}

/// An earlier frame's picture; null: it must be traced.
LastPictures::Picture* Pictures::known(const scene::Snapshot& snapshot, const Wish& wish,
                                       bool refines) noexcept {
  LastPictures::Picture* const known = last_.of(snapshot, wish.missColor);
  if (known && refines && !known->refined) return known;
  // A finished full structure takes memory beside the fast one until a trace installs it: do not repeat then.
  return known && !(improves_ && improves_()) ? known : nullptr;
}

Pictures::Result Pictures::of(const scene::Snapshot& snapshot, const Wish& wish) {
  Result result;
  const bool ahead = ahead_ && ahead_->has(snapshot);
  const bool refines = isRefinable(snapshot);
  const bool full = wish.finished || snapshot.lightSampling.mode == scene::LightSampling::Mode::full;
  if (!refines) last_.forgetPasses();
  if (auto* const picture = wish.mayRepeat && !ahead ? known(snapshot, wish, refines) : nullptr) {
    result.repeated = true, result.picture = picture;
    if (refines && !picture->refined) refine(snapshot, *picture, full, result);
    return result;
  }
  last_.forgetPasses(snapshot.view);
  LastPictures::Picture& fresh = last_.next();
  fresh.image.missColor = wish.missColor.value_or(0);
  const bool done = ahead ? ahead_->take(fresh.image, result.cost, result.why)
                          : (refines && full && finish(snapshot, fresh, result)) ||
                                trace_(snapshot, fresh.image, result.cost, result.why);
  if (!done) return result;
  last_.keep(snapshot);
  result.picture = &fresh;
  return result;
}

bool Pictures::startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late) {
  if (!ahead_) ahead_ = std::make_unique<TraceAhead>(trace_);
  return ahead_->start(std::move(snapshot), missColor, std::move(late));
}

void Pictures::dropAhead() noexcept {
  if (ahead_) ahead_->drop();
}

}  // namespace gluray::frame
