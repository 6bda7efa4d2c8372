#include "frame/pictures/traced_pictures.h"

#include "base/clock.h"
#include "base/log.h"
#include "frame/refinement/noise_picture.h"
#include "scene/effects.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::frame {
namespace {

void logUnrefined(const std::string& why) {
  log::once(log::Level::warning, "refinement", "cannot refine a picture: " + why + "; it keeps its noise");
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

/// Traces at least one pass, because showing needs one. Stops when the picture is finished or, unless
/// `finish`, when the time is up. False: a pass failed.
bool tracePasses(Refiner& refiner, const Trace& trace, uint32_t missColor, bool finish, double mostSeconds,
                 TracedPictures::Result& result) {
  const double start = nowSeconds();
  double now = start, last = 0;
  while (!refiner.elsewhere() &&
         (!refiner.hasPass() ||
          (!refiner.finished() && (finish || result.passes == 0 || now + last < start + mostSeconds)))) {
    if (!refiner.pass(trace, missColor, result.cost, result.why)) return false;
    ++result.passes;
    last = nowSeconds() - now, now += last;
  }
  return true;
}

}  // namespace

/// Traces all passes of a new picture. False: not even the first one was possible.
bool TracedPictures::finish(const scene::Snapshot& snapshot, LastPictures::Picture& picture,
                            Result& result) noexcept {
  try {
    Refinement refinement;
    Refiner refiner(snapshot, refinement);
    const bool all = tracePasses(refiner, tracer_.trace, picture.image.missColor, true, 0, result);
    if (!all) logUnrefined(std::exchange(result.why, {}));
    if (const Image* const image = refiner.elsewhere()) {
      picture.image = *image;
      return picture.refined = refiner.finishedElsewhere(), true;
    }
    if (refinement.passes() == 0) return false;
    refiner.show(picture.image);
    result.noise = refinement.noise();
    return picture.refined = true;
  } catch (const std::exception& e) { return logUnrefined(e.what()), false; }
}

/// Adds passes to a known picture. Whatever fails, the picture stays as good as it was.
void TracedPictures::refine(const scene::Snapshot& snapshot, LastPictures::Picture& picture, bool finish,
                            Result& result) noexcept {
  try {
    auto passes = std::exchange(picture.refinement, nullptr);
    if (!passes) passes = frame_.takePasses(picture.id);
    if (!passes) passes = std::make_unique<Refinement>();
    Refiner refiner(snapshot, *passes);
    const bool all = tracePasses(refiner, tracer_.trace, picture.image.missColor, finish,
                                 redrawSeconds(snapshot.settings), result);
    if (!all) logUnrefined(std::exchange(result.why, {}));
    if (const Image* const image = refiner.elsewhere()) {
      last_.renew(picture);
      picture.image = *image;
      picture.refined = refiner.finishedElsewhere();
      result.repeated = false;
      return;
    }
    // Fewer passes may be worse than the first picture, which may have been filtered.
    if (result.passes > 0 && (refiner.finished() || passes->passes() >= kMinPasses)) {
      last_.renew(picture);
      refiner.show(picture.image);
      result.repeated = false;
      result.noise = passes->noise();
    }
    picture.refined = refiner.finished() || !all;
    if (!picture.refined) picture.refinement = std::move(passes);
  } catch (const std::exception& e) {
    logUnrefined(e.what());
    picture.refined = true;
  }
}

/// A picture that was traced before and shows the snapshot now; null: none.
LastPictures::Picture* TracedPictures::lastOf(const scene::Snapshot& snapshot,
                                              std::optional<uint32_t> missColor) noexcept {
  using Of = LastPictures::Of;
  const bool alone = !tracer_.standsAlone || tracer_.standsAlone(snapshot);
  return last_.findPicture(snapshot, missColor, alone ? Of::equalSnapshot : Of::thisSnapshot);
}

/// An earlier frame's picture whose misses may get another colour; null: none. Passes of layers contain that.
LastPictures::Picture* TracedPictures::recolorable(const scene::Snapshot& snapshot) noexcept {
  LastPictures::Picture* const picture = snapshot.layers ? nullptr : lastOf(snapshot);
  return picture && picture->image.has(Plane::color) && picture->image.samples == 1 ? picture : nullptr;
}

/// An earlier frame's picture with misses in `missColor`, if given. A frame has one picture, however it is
/// shown: a second one would have passes and noise of its own.
LastPictures::Picture* TracedPictures::ofColor(const scene::Snapshot& snapshot,
                                               std::optional<uint32_t> missColor) noexcept {
  if (auto* const same = lastOf(snapshot, missColor)) return same;
  LastPictures::Picture* const other = missColor ? recolorable(snapshot) : nullptr;
  if (!other) return nullptr;
  if (!other->refinement) other->refinement = frame_.takePasses(other->id);
  last_.renew(*other);
  colorMisses(*missColor, other->image);
  return other;
}

/// An earlier frame's picture; null: it must be traced.
LastPictures::Picture* TracedPictures::known(const scene::Snapshot& snapshot, const Wish& wish,
                                             bool refines) noexcept {
  LastPictures::Picture* const known = ofColor(snapshot, wish.missColor);
  if (known && refines && !known->refined) return known;
  // A finished full structure takes memory beside the fast one until a trace installs it: do not repeat then.
  return known && !(tracer_.improves && tracer_.improves()) ? known : nullptr;
}

/// Traces a new picture in one pass: with all samples, whatever the snapshot asks for, if it is to be `full`.
bool TracedPictures::traceOnce(const scene::Snapshot& snapshot, bool full, LastPictures::Picture& picture,
                               Result& result) {
  using Mode = scene::LightSampling::Mode;
  picture.moving = !full && snapshot.lightSampling.mode == Mode::moving;
  if (picture.moving || snapshot.lightSampling.mode == Mode::full)
    return tracer_.trace(snapshot, picture.image, result.cost, result.why);
  scene::Snapshot all = snapshot;
  all.lightSampling.mode = Mode::full;
  return tracer_.trace(all, picture.image, result.cost, result.why);
}

void TracedPictures::tellShown(const scene::Snapshot& snapshot, const LastPictures::Picture& picture,
                               const Result& result) noexcept {
  if (tracer_.shown && !result.cost.elsewhere) tracer_.shown(snapshot, picture.image, picture.refined);
}

TracedPictures::Result TracedPictures::pictureOf(const scene::Snapshot& snapshot, const Wish& wish) {
  Result result;
  if (auto* const picture = wish.asShown ? ofColor(snapshot, wish.missColor) : nullptr) {
    result.repeated = true, result.picture = picture;
    return result;
  }
  frame_.nextFrame();
  const bool ahead = ahead_ && ahead_->has(snapshot);
  const bool refines = isRefinable(snapshot);
  bool full = wish.finished || snapshot.lightSampling.mode == scene::LightSampling::Mode::full;
  if (!refines) last_.forgetPasses();
  if (auto* const picture = wish.mayRepeat && !ahead ? known(snapshot, wish, refines) : nullptr) {
    if (refines || !picture->moving) {
      result.repeated = true, result.picture = picture;
      if (refines && !picture->refined) refine(snapshot, *picture, full, result);
      if (!result.repeated) tellShown(snapshot, *picture, result);
      return result;
    }
    last_.drop(*picture);
    full = true;  // nothing moves
  }
  last_.forgetPasses(snapshot.view);
  LastPictures::Picture& fresh = last_.makeRoom();
  fresh.image.missColor = wish.missColor.value_or(0);
  fresh.moving = false;
  const bool finished = !ahead && refines && full && finish(snapshot, fresh, result);
  const bool done = finished || (ahead ? ahead_->takePicture(fresh.image, result.cost, result.why)
                                       : traceOnce(snapshot, full, fresh, result));
  if (!done) return result;
  if (!finished && !result.cost.elsewhere) paintUnrefined(snapshot, fresh.image);
  if (result.cost.elsewhere) fresh.refined = result.cost.refined;
  last_.keep(snapshot);
  tellShown(snapshot, fresh, result);
  result.picture = &fresh;
  return result;
}

bool TracedPictures::startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late) {
  if (!ahead_) ahead_ = std::make_unique<TraceAhead>(tracer_.trace);
  return ahead_->start(std::move(snapshot), missColor, std::move(late));
}

void TracedPictures::dropAhead() noexcept {
  if (ahead_) ahead_->drop();
}

}  // namespace gluray::frame
