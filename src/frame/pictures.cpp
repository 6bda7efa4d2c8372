#include "frame/pictures.h"

#include "base/clock.h"
#include "base/log.h"
#include "frame/noise_picture.h"
#include "scene/effects.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace gluray::frame {
namespace {

void logFailure(const std::string& why) {
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

/// Traces passes until the picture is finished or, unless it must be, the time is up. False: a pass failed.
bool tracePasses(Refiner& refiner, const Trace& trace, uint32_t missColor, bool finish, double mostSeconds,
                 Pictures::Result& result) {
  const double start = nowSeconds();
  double now = start, last = 0;
  while (!refiner.finished() && (finish || result.passes == 0 || now + last < start + mostSeconds)) {
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
    const bool all = tracePasses(refiner, tracer_.trace, picture.image.missColor, true, 0, result);
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
    if (idle_ && !passes) passes = idle_->take(picture.id);
    if (!passes) passes = std::make_unique<Refinement>();
    Refiner refiner(snapshot, *passes);
    const bool all = tracePasses(refiner, tracer_.trace, picture.image.missColor, finish,
                                 redrawSeconds(snapshot.settings), result);
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
  return known && !(tracer_.improves && tracer_.improves()) ? known : nullptr;
}

/// Traces a new picture in one pass: with all samples, whatever the snapshot asks for, if it is to be `full`.
bool Pictures::traceOnce(const scene::Snapshot& snapshot, bool full, LastPictures::Picture& picture,
                         Result& result) {
  using Mode = scene::LightSampling::Mode;
  picture.moving = !full && snapshot.lightSampling.mode == Mode::moving;
  if (picture.moving || snapshot.lightSampling.mode == Mode::full)
    return tracer_.trace(snapshot, picture.image, result.cost, result.why);
  scene::Snapshot all = snapshot;
  all.lightSampling.mode = Mode::full;
  return tracer_.trace(all, picture.image, result.cost, result.why);
}

Pictures::Result Pictures::of(const scene::Snapshot& snapshot, const Wish& wish) {
  Result result;
  if (idle_) idle_->stop();
  const bool ahead = ahead_ && ahead_->has(snapshot);
  const bool refines = isRefinable(snapshot);
  bool full = wish.finished || snapshot.lightSampling.mode == scene::LightSampling::Mode::full;
  if (!refines) last_.forgetPasses();
  if (auto* const picture = wish.mayRepeat && !ahead ? known(snapshot, wish, refines) : nullptr) {
    if (refines || !picture->moving) {
      result.repeated = true, result.picture = picture;
      if (refines && !picture->refined) refine(snapshot, *picture, full, result);
      return result;
    }
    last_.drop(*picture);
    full = true;  // nothing moves
  }
  last_.forgetPasses(snapshot.view);
  LastPictures::Picture& fresh = last_.next();
  fresh.image.missColor = wish.missColor.value_or(0);
  fresh.moving = false;
  const bool finished = !ahead && refines && full && finish(snapshot, fresh, result);
  const bool done = finished || (ahead ? ahead_->take(fresh.image, result.cost, result.why)
                                       : traceOnce(snapshot, full, fresh, result));
  if (!done) return result;
  if (!finished) paintUnrefined(snapshot, fresh.image);
  last_.keep(snapshot);
  result.picture = &fresh;
  return result;
}

namespace {

/// Pixels of a multisampled picture whose samples differ.
std::vector<bool> mixedPixels(const Image& image) {
  if (image.samples == 1) return {};
  const size_t pixels = image.color.size() / static_cast<size_t>(image.samples);
  std::vector<bool> mixed(pixels);
  for (size_t i = pixels; i < image.color.size(); ++i)
    if (image.color[i] != image.color[i % pixels]) mixed[i % pixels] = true;
  return mixed;
}

}  // namespace

void Pictures::wrote(const scene::SnapshotPtr& snapshot, const LastPictures::Picture& picture,
                     const Image& pixels, const scene::Resolve* how) noexcept {
  constexpr size_t kMost = 4;  // views of one window
  const bool refines = tracer_.behind && snapshot->settings.refine.idle &&
                       snapshot->lightSampling.mode == scene::LightSampling::Mode::moving &&
                       !picture.refined && pixels.has(Plane::color) && isRefinable(*snapshot);
  if (!written_.empty() && written_.front().snapshot->frame != snapshot->frame)
    written_.clear(), antialiased_.clear();
  if (!refines) return;
  const auto known = std::find_if(written_.begin(), written_.end(),
                                  [&](const IdlePicture& one) { return one.id == picture.id; });
  if (known != written_.end()) return;
  if (written_.size() == kMost) return void(tooMany_ = true);
  try {
    IdlePicture one{snapshot, picture.id, {pixels.x, pixels.y}, {pixels.width, pixels.height}, pixels.color};
    if (how) one.resolve = *how;
    one.mixed = mixedPixels(pixels);
    one.colors.resize(static_cast<size_t>(pixels.width) * static_cast<size_t>(pixels.height));
    written_.push_back(std::move(one));
  } catch (const std::exception&) { tooMany_ = true; }  // out of memory: the frame keeps its noise
}

void Pictures::antialiased(const scene::Fxaa& how, const scene::Region& region, const uint32_t* before,
                           const Settings& settings) noexcept {
  constexpr size_t kMost = 4;  // views of one window
  if (written_.empty()) return;
  if (antialiased_.size() == kMost) return void(tooMany_ = true);
  try {
    const size_t pixels = static_cast<size_t>(region.width) * static_cast<size_t>(region.height);
    antialiased_.push_back({how, region, settings, {before, before + pixels}});
  } catch (const std::exception&) { tooMany_ = true; }  // out of memory: the frame keeps its noise
}

void Pictures::refineWhileIdle(const std::function<std::shared_ptr<IdleWindow>()>& open) noexcept {
  using namespace std::chrono_literals;
  constexpr auto kQuiet = 100ms;  // frames that follow each other come sooner
  const bool refines = !written_.empty() && !std::exchange(tooMany_, false);
  std::vector<IdlePicture> written = std::exchange(written_, {});
  std::vector<IdleFxaa> passes = std::exchange(antialiased_, {});
  try {
    if (!refines) return idle_ ? idle_->start({}, nullptr) : void();
    if (!idle_) idle_ = std::make_unique<IdleRefiner>(tracer_, kQuiet);
    for (IdlePicture& one : written)
      if (auto* const picture = last_.withId(one.id)) one.refinement = std::move(picture->refinement);
    idle_->start(std::move(written), open(), std::move(passes));
  } catch (const std::exception&) {}  // out of memory: the frame keeps its noise
}

void Pictures::stopRefining() noexcept {
  if (idle_) idle_->stop();
}

bool Pictures::startAhead(scene::SnapshotPtr snapshot, uint32_t missColor, TraceAhead::Late late) {
  if (!ahead_) ahead_ = std::make_unique<TraceAhead>(tracer_.trace);
  return ahead_->start(std::move(snapshot), missColor, std::move(late));
}

void Pictures::dropAhead() noexcept {
  if (ahead_) ahead_->drop();
}

}  // namespace gluray::frame
