#include "frame/images/traced_images.h"

#include "base/clock.h"
#include "base/log.h"
#include "frame/refinement/denoiser.h"
#include "frame/refinement/noise_image.h"
#include "frame/refinement/refinement_progress.h"
#include "scene/effects.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::frame {
namespace {

void logUnrefined(const std::string& why) {
  log::once(log::Level::warning, "refinement", "cannot refine an image: " + why + "; it keeps its noise");
}

/// Time for passes when a program draws the same frame again: as long as a moving frame may take.
double redrawSeconds(const Settings& settings) { return 1 / std::max(double{settings.fps}, 1.0); }

/// In place of colours where passes tell nothing of the noise (look = noise).
void paintUnrefined(const scene::Snapshot& snapshot, Image& image) {
  if (snapshot.settings.look != Look::noise || snapshot.layers) return;
  if (scene::wantsLight(snapshot.settings))
    paintNoise({}, snapshot.settings.noise, image);
  else
    paintNoNoise(image);
}

void colorMisses(uint32_t color, Image& image) {
  const uint32_t before = std::exchange(image.missColor, color);
  if (image.isAverages()) return;  // misses are 0
  for (size_t i = 0; i < image.color.size(); ++i)
    if (image.depth[i] == Image::kMiss && image.color[i] == before) image.color[i] = color;
}

/// Traces at least one pass, because showing needs one. Stops when the image is finished or, unless
/// `finish`, when the time is up. False: a pass failed.
bool tracePasses(Refiner& refiner, const Trace& trace, uint32_t missColor, bool finish, double mostSeconds,
                 TracedImages::Result& result) {
  const double start = nowSeconds();
  double now = start, last = 0;
  std::optional<ProgressTeller> progress;
  if (finish) progress.emplace(refiner.settings());
  while (!refiner.elsewhere() &&
         (!refiner.hasPass() ||
          (!refiner.finished() && (finish || result.passes == 0 || now + last < start + mostSeconds)))) {
    if (!refiner.pass(trace, missColor, result.cost, result.why)) return false;
    ++result.passes;
    last = nowSeconds() - now, now += last;
    if (progress) progress->passed(refiner.refinement());
  }
  return true;
}

}  // namespace

/// Traces all passes of a new image. False: not even the first one was possible.
bool TracedImages::finish(const scene::Snapshot& snapshot, ImageCache::CachedImage& cached,
                          Result& result) noexcept {
  try {
    Refinement refinement;
    Refiner refiner(snapshot, refinement);
    const bool all = tracePasses(refiner, tracer_.trace, cached.image.missColor, true, 0, result);
    if (!all) logUnrefined(std::exchange(result.why, {}));
    if (const Image* const image = refiner.elsewhere()) {
      cached.image = *image;
      return cached.refined = refiner.finishedElsewhere(), true;
    }
    if (refinement.passes() == 0) return false;
    refiner.show(cached.image);
    result.noise = refinement.noise();
    return cached.refined = true;
  } catch (const std::exception& e) { return logUnrefined(e.what()), false; }
}

/// Adds passes to a known image. Whatever fails, the image stays as good as it was.
void TracedImages::refine(const scene::Snapshot& snapshot, ImageCache::CachedImage& cached, bool finish,
                          Result& result) noexcept {
  try {
    auto passes = std::exchange(cached.refinement, nullptr);
    if (!passes) passes = frame_.takePasses(cached.id);
    if (!passes) passes = std::make_unique<Refinement>();
    Refiner refiner(snapshot, *passes);
    const bool all = tracePasses(refiner, tracer_.trace, cached.image.missColor, finish,
                                 redrawSeconds(snapshot.settings), result);
    if (!all) logUnrefined(std::exchange(result.why, {}));
    if (const Image* const image = refiner.elsewhere()) {
      last_.renew(cached);
      cached.image = *image;
      cached.refined = refiner.finishedElsewhere();
      result.repeated = false;
      return;
    }
    // Fewer passes may be worse than the first image, which may have been filtered.
    if (result.passes > 0 && (refiner.finished() || passes->passes() >= kMinPasses)) {
      last_.renew(cached);
      refiner.show(cached.image);
      result.repeated = false;
      result.noise = passes->noise();
    }
    cached.refined = refiner.finished() || !all;
    if (!cached.refined) cached.refinement = std::move(passes);
  } catch (const std::exception& e) {
    logUnrefined(e.what());
    cached.refined = true;
  }
}

/// An image that was traced before and shows the snapshot now; null: none.
ImageCache::CachedImage* TracedImages::lastOf(const scene::Snapshot& snapshot,
                                              std::optional<uint32_t> missColor) noexcept {
  using Of = ImageCache::Of;
  const bool alone = !tracer_.standsAlone || tracer_.standsAlone(snapshot);
  return last_.findImage(snapshot, missColor, alone ? Of::equalSnapshot : Of::thisSnapshot);
}

/// An earlier frame's image whose misses may get another colour; null: none. Passes of layers contain that.
ImageCache::CachedImage* TracedImages::recolorable(const scene::Snapshot& snapshot) noexcept {
  ImageCache::CachedImage* const cached = snapshot.layers ? nullptr : lastOf(snapshot);
  return cached && cached->image.has(Plane::color) && cached->image.samples == 1 ? cached : nullptr;
}

/// An earlier frame's image with misses in `missColor`, if given. A frame has one image, however it is
/// shown: a second one would have passes and noise of its own.
ImageCache::CachedImage* TracedImages::ofColor(const scene::Snapshot& snapshot,
                                               std::optional<uint32_t> missColor) noexcept {
  if (auto* const same = lastOf(snapshot, missColor)) return same;
  ImageCache::CachedImage* const other = missColor ? recolorable(snapshot) : nullptr;
  if (!other) return nullptr;
  if (!other->refinement) other->refinement = frame_.takePasses(other->id);
  last_.renew(*other);
  colorMisses(*missColor, other->image);
  return other;
}

/// An earlier frame's image; null: it must be traced.
ImageCache::CachedImage* TracedImages::known(const scene::Snapshot& snapshot, const Wish& wish,
                                             bool refines) noexcept {
  ImageCache::CachedImage* const known = ofColor(snapshot, wish.missColor);
  if (known && refines && !known->refined) return known;
  // A finished full structure takes memory beside the fast one until a trace installs it: do not repeat then.
  return known && !(tracer_.improves && tracer_.improves()) ? known : nullptr;
}

/// Traces a new image in one pass: with all samples, whatever the snapshot asks for, if it is to be `full`.
bool TracedImages::traceOnce(const scene::Snapshot& snapshot, bool full, const Wish& wish,
                             ImageCache::CachedImage& cached, Result& result) {
  using Mode = scene::LightSampling::Mode;
  cached.moving = !full && snapshot.lightSampling.mode == Mode::moving;
  const bool aliased = cached.moving && (wish.anew ? !wish.averages : frame_.restsInWindow());
  if (!wish.anew && !aliased && (cached.moving || snapshot.lightSampling.mode == Mode::full))
    return tracer_.trace(snapshot, cached.image, result.cost, result.why);
  scene::Snapshot all = snapshot;
  all.lightSampling.anew = wish.anew, all.lightSampling.aliased = aliased;
  if (!cached.moving) all.lightSampling.mode = Mode::full;
  return tracer_.trace(all, cached.image, result.cost, result.why);
}

void TracedImages::tellShown(const scene::Snapshot& snapshot, const ImageCache::CachedImage& cached,
                             const Result& result) noexcept {
  if (tracer_.shown && !result.cost.elsewhere) tracer_.shown(snapshot, cached.image, cached.refined);
}

TracedImages::Result TracedImages::imageOf(const scene::Snapshot& snapshot, const Wish& wish) {
  Result result;
  if (auto* const cached = wish.asShown ? ofColor(snapshot, wish.missColor) : nullptr) {
    result.repeated = true, result.cached = cached;
    return result;
  }
  frame_.nextFrame();
  const bool ahead = ahead_ && ahead_->has(snapshot);
  const bool refines = isRefinable(snapshot);
  logUndenoised(snapshot);
  bool full = wish.finished || snapshot.lightSampling.mode == scene::LightSampling::Mode::full;
  if (!refines) last_.forgetPasses();
  if (auto* const cached = wish.mayRepeat && !ahead ? known(snapshot, wish, refines) : nullptr) {
    if (refines || !cached->moving) {
      result.repeated = true, result.cached = cached;
      if (refines && !cached->refined) refine(snapshot, *cached, full, result);
      if (!result.repeated) tellShown(snapshot, *cached, result);
      return result;
    }
    last_.drop(*cached);
    full = true;  // nothing moves
  }
  last_.forgetPasses(snapshot.view);
  ImageCache::CachedImage& fresh = last_.makeRoom();
  fresh.image.missColor = wish.missColor.value_or(0);
  fresh.moving = false;
  const bool finished = !ahead && refines && full && finish(snapshot, fresh, result);
  const bool done = finished || (ahead ? ahead_->takeImage(fresh.image, result.cost, result.why)
                                       : traceOnce(snapshot, full, wish, fresh, result));
  if (!done) return result;
  if (!finished && !result.cost.elsewhere) paintUnrefined(snapshot, fresh.image);
  if (result.cost.elsewhere) fresh.refined = result.cost.refined;
  last_.keep(snapshot);
  tellShown(snapshot, fresh, result);
  result.cached = &fresh;
  return result;
}

bool TracedImages::startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late) {
  if (!ahead_) ahead_ = std::make_unique<TraceAhead>(tracer_.trace);
  return ahead_->start(std::move(snapshot), missColor, std::move(late));
}

void TracedImages::dropAhead() noexcept {
  if (ahead_) ahead_->drop();
}

}  // namespace gluray::frame
