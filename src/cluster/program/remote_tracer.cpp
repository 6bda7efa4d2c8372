#include "cluster/program/remote_tracer.h"

#include "base/clock.h"
#include "render/tiles/tiles.h"

#include <chrono>
#include <exception>
#include <thread>
#include <utility>

namespace gluray::cluster {
namespace {

constexpr double kObserved = 5, kObserveEvery = 0.25;  // seconds
constexpr int kObserveMs = 10;
constexpr int kLookMs = 20;  // how often a call looks whether it must stop

/// Copies the image, or of a pass over some tiles those.
void copyPixels(const scene::Snapshot& snapshot, const ImageDone& done, const std::byte* pixels,
                Image& image) {
  const ImageShape& shape = done.shape;
  const auto* const wanted = snapshot.lightSampling.tiles.get();
  const bool some = wanted && shapeOf(image) == shape;
  image.x = snapshot.region.x, image.y = snapshot.region.y;
  if (!some) image.resize(shape.width, shape.height, shape.samples, shape.planes);
  const PlanePointers from = planesIn(const_cast<std::byte*>(pixels), shape), to = planesOf(image);
  const render::Tiles tiles(shape.width, shape.height, render::kTileSize);
  for (int tile = 0; tile < tiles.columns * tiles.rows; ++tile)
    if (!some || static_cast<size_t>(tile) >= wanted->size() || (*wanted)[static_cast<size_t>(tile)])
      copyTile(from, to, shape, tiles.at(tile));
  image.layers = done.layers;
}

}  // namespace

RemoteTracer::RemoteTracer(std::string directory, std::string job, MpiPlace place, frame::TraceBehind here,
                           std::function<void(const std::string&)> say)
    : job_(job),
      hasPeers_(place.ranks > 1),
      here_(std::move(here)),
      say_(std::move(say)),
      link_(std::move(directory), std::move(job), std::move(place)) {}

void RemoteTracer::shown(const scene::Snapshot& snapshot, const Image& image, bool finished) noexcept {
  try {
    const std::lock_guard lock(mutex_);
    if (!link_.isGathered(snapshot) || link_.isMadeElsewhere(snapshot)) return;
    if (!link_.show(snapshot, image, finished)) link_.lose("the worker is gone", nowSeconds());
  } catch (const std::exception& why) {  // the other ranks trace their parts
    say_(std::string("the other ranks do not get the image: ") + why.what());
  }
}

void RemoteTracer::tell(const std::string& why, bool isAway) {
  // A worker that was lost may first be silent, and then no longer run.
  if (!traced_ && (why == told_ || (isAway && toldOfLoss_))) return;
  told_ = why, toldOfLoss_ = isAway && traced_;
  traced_ = false;
  say_("workers = " + job_ + ": " + why + "; this process traces in the meantime");
}

bool RemoteTracer::leavesOut(const scene::Snapshot& snapshot) const {
  return scene::hasScenery(snapshot) && hasPeers_ && snapshot.settings.gather;
}

void RemoteTracer::leaveSceneryOut() noexcept {
  if (toldOfScenery_.exchange(true)) return;
  say_(
      "gather: ground and background are left out: no framebuffer of a rank that draws holds the composited "
      "image of all ranks over a uniform background");
}

bool RemoteTracer::isGathered(const scene::Snapshot& snapshot) noexcept {
  const std::lock_guard lock(mutex_);
  return link_.isGathered(snapshot) && !link_.isMadeElsewhere(snapshot);
}

bool RemoteTracer::trace(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                         std::string& error, const std::function<bool()>& stop) noexcept {
  if (!leavesOut(snapshot)) return traceAll(snapshot, image, cost, error, stop);
  try {
    scene::Snapshot without = snapshot;
    without.ground = scene::GroundUse::none;
    without.backdrop = nullptr;
    if (!traceAll(without, image, cost, error, stop)) return false;
    const std::lock_guard lock(mutex_);
    if (!link_.isGathered(snapshot) && scene::showsScenery(snapshot)) leaveSceneryOut();
    return true;
  } catch (const std::bad_alloc&) {
    cost.loss = scene::Loss::frames;
    return error = "out of memory", false;
  }
}

bool RemoteTracer::traceComplete(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                                 std::string& error) noexcept {
  try {
    scene::Snapshot complete = snapshot;
    complete.view = ~snapshot.view;  // it has buffers of its own
    return traceAll(complete, image, cost, error, nullptr);
  } catch (const std::bad_alloc&) {
    cost.loss = scene::Loss::frames;
    return error = "out of memory", false;
  }
}

bool RemoteTracer::traceAll(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                            std::string& error, const std::function<bool()>& stop) noexcept {
  Result result = Result::nobody;
  try {
    error.clear();
    const struct Wanted {
      explicit Wanted(std::atomic<int>* count) : count(count) {
        if (count) ++*count;
      }
      ~Wanted() {
        if (count) --*count;
      }
      std::atomic<int>* count;
    } wanted(stop ? nullptr : &wanted_);
    std::unique_lock lock(mutex_, std::defer_lock);
    if (!stop)
      lock.lock();
    else if (!lock.try_lock() || wanted_ > 0)
      return false;
    if (stop && link_.isMadeElsewhere(snapshot)) return error = "another rank makes the image", false;
    result = byWorkers(snapshot, image, cost, error, stop);
    // An image of this rank's part would lack what the others leave to it, or show what they show.
    if ((result == Result::nobody || result == Result::failed) && link_.isGathered(snapshot)) {
      if (error.empty()) error = "the workers of all ranks do not answer";
      if (cost.loss == scene::Loss::tracing) cost.loss = scene::Loss::frames;  // they may answer again
      return false;
    }
  } catch (const std::exception&) {}  // no memory: the other way may need less
  reach_ = result == Result::nobody ? Reach::alone : Reach::connected;
  if (result == Result::done) return true;
  if (result == Result::stopped) return false;
  return here_(snapshot, image, cost, error, stop);
}

bool RemoteTracer::lockWithin(int timeoutMs) {
  for (int waited = 0; !mutex_.try_lock(); ++waited) {
    if (waited >= timeoutMs) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

void RemoteTracer::askFigures(int timeoutMs) {
  if (!link_.askFigures(timeoutMs)) return;
  const std::lock_guard lock(figuresMutex_);
  figures_ = link_.figures();
}

void RemoteTracer::observe() {
  const double now = nowSeconds();
  if (now > observedUntil_ || now < observed_ + kObserveEvery) return;
  observed_ = now;
  askFigures(kObserveMs);
}

std::vector<RankFigures> RemoteTracer::observedFigures() {
  observedUntil_ = nowSeconds() + kObserved;
  const std::lock_guard lock(figuresMutex_);
  return figures_;
}

std::vector<RankFigures> RemoteTracer::figures(int timeoutMs) noexcept {
  try {
    if (lockWithin(timeoutMs)) {
      const std::lock_guard lock(mutex_, std::adopt_lock);
      askFigures(timeoutMs);
      return link_.figures();
    }
  } catch (const std::exception&) {}  // no memory, or an answer that cannot be read
  return {};
}

void RemoteTracer::sayEnd(int timeoutMs) noexcept {
  if (!lockWithin(timeoutMs)) return;
  const std::lock_guard lock(mutex_, std::adopt_lock);
  link_.sayEnd(timeoutMs);
}

RemoteTracer::Result RemoteTracer::byWorkers(const scene::Snapshot& snapshot, Image& image,
                                             scene::TraceCost& cost, std::string& error,
                                             const std::function<bool()>& stop) {
  const double now = nowSeconds();
  if (!link_.isReady(now)) return tell(link_.why(), link_.isAway()), Result::nobody;
  try {
    if (!link_.ask(snapshot, image.missColor)) {
      link_.lose("the worker is gone", now);
      return tell(link_.why(), link_.isAway()), Result::nobody;
    }
    const Result result = receive(snapshot, image, cost, error, stop);
    if (result == Result::done) traced_ = true, observe();
    return result;
  } catch (const std::exception& why) {
    link_.disconnect(why.what(), nowSeconds());
    tell(link_.why());
  }
  return Result::nobody;
}

RemoteTracer::Result RemoteTracer::receive(const scene::Snapshot& snapshot, Image& image,
                                           scene::TraceCost& cost, std::string& error,
                                           const std::function<bool()>& stop) {
  for (;;) {
    if (stop && (wanted_ > 0 || stop())) return link_.cancel(), Result::stopped;
    switch (link_.wait(kLookMs, nowSeconds())) {
      case WorkerLink::Came::nothing:
      case WorkerLink::Came::sign: continue;
      case WorkerLink::Came::failure:
        link_.lose("the worker does not answer", nowSeconds());
        return tell(link_.why(), link_.isAway()), Result::nobody;
      case WorkerLink::Came::image: break;
    }
    const ImageDone& done = link_.done();
    if (!done.whole) {
      tell(done.error);
      cost.loss = done.cost.loss;
      return error = done.error, Result::failed;
    }
    copyPixels(snapshot, done, link_.pixels(), image);
    cost = done.cost;
    improves_ = done.improves;
    if (done.note != toldNote_ && !(toldNote_ = done.note).empty())
      say_("gather: " + toldNote_ + ": each rank traces its own part");
    return Result::done;
  }
}

}  // namespace gluray::cluster
