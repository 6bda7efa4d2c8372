#include "frame/tracing/renderer.h"

#include "accel/world.h"
#include "base/ample_stack.h"
#include "base/clock.h"
#include "base/log.h"
#include "base/timeline.h"
#include "frame/tracing/pace.h"
#include "frame/tracing/view_exposures.h"
#include "parallel/arena.h"
#include "render/exposure/light_meter.h"
#include "render/ground/staged_scene.h"
#include "render/resolve/anti_alias.h"
#include "render/resolve/resolve_samples.h"
#include "render/tile_tracer.h"
#include "render/tiles/float_guard.h"
#include "render/volume_light/medium.h"
#include "render/volume_light/volume_light.h"
#include "scene/effects.h"

#include <atomic>
#include <map>
#include <mutex>
#include <optional>

namespace gluray::frame {
namespace {

std::atomic<uint64_t> g_contextsGone{0};

}  // namespace

void Renderer::contextGone() noexcept { ++g_contextsGone; }

/// State kept between frames. Each part is made at its first use, and again if that failed.
class Renderer::Engine {
 public:
  explicit Engine(Threads threads) : threads_(threads) {}

  std::mutex mutex;
  std::atomic<int> wanted{0};  // calls that wait for the renderer or use it, without those behind all others

  bool render(const scene::Snapshot& given, Image& image, scene::TraceCost& cost,
              render::TraceOptions options = {}) {
    cost = {};
    if (given.settings.renderer == gluray::Renderer::null && !options.source)
      return render::clearImage(given, image), true;
    const render::StagedScene staged(given);
    const scene::Snapshot& snapshot = staged.snapshot();

    const render::FloatGuard guard;
    const double start = nowSeconds();
    prepareArena(snapshot.settings.threads);
    if (!world_) world_.emplace();
    if (const uint64_t gone = g_contextsGone; gone != contextsGone_) {
      contextsGone_ = gone;
      world_->releaseOrphans();
    }
    const accel::UpdateStatistics update = [&] {
      const timeline::Span span("build", snapshot.instances.size());
      return world_->update(snapshot, *arena_, staged.hidden());
    }();
    cost.blasBuilds = update.blasBuilds;
    cost.tlasBuilds = update.tlasBuilds;
    cost.blasRefinements = update.blasRefinements;
    cost.bvhBytes = world_->bytes();
    cost.blasRefining = world_->refining();
    // The rays of frames that processes share are given.
    const bool paced = isMoving(snapshot) && (!options.source || options.remote);
    const double built = nowSeconds();
    cost.buildSeconds = built - start;
    const timeline::Span span("trace");
    if (paced) options.rays = paces_[snapshot.view].rays();
    options.litExposure = exposureOf(snapshot, options);
    options.histories = &histories_;
    const auto took = [&](double seconds) {
      cost.traceSeconds = seconds;
      if (paced) paces_[snapshot.view].took(seconds, 1 / static_cast<double>(snapshot.settings.fps));
    };
    if (options.remote) options.traced = took;
    if (render::hasLight(snapshot)) options.media = media_.of(snapshot, *arena_);
    const bool whole = render::traceImage(snapshot, *world_, *arena_, image, options);
    if (!options.remote) took(nowSeconds() - built);
    return whole;
  }

  std::shared_ptr<const render::SampleIllumination> illuminate(const scene::Snapshot& given) {
    const timeline::Span span("volume light");
    const render::StagedScene staged(given);
    const render::FloatGuard guard;
    prepareArena(given.settings.threads);
    if (!world_) world_.emplace();
    world_->update(staged.snapshot(), *arena_, staged.hidden());
    return volumeLights_.arriving({staged.snapshot(), given.volumes.front()}, *world_, media_, *arena_);
  }

  bool improves() const { return world_ && world_->refined(); }

  void antialias(const Settings& settings, const scene::Fxaa& fxaa, const uint32_t* in, int width, int height,
                 uint32_t* out) {
    prepareArena(settings.threads);
    const timeline::Span span("anti-alias");
    arena_->execute([&] { render::fxaa(fxaa, in, width, height, out, fxaaMemory_); });
  }

  void resolve(const Settings& settings, const scene::Resolve& how, const Image& samples, Image& out) {
    prepareArena(settings.threads);
    const timeline::Span span("resolve");
    arena_->execute([&] { render::resolve(how, samples, out); });
  }

 private:
  /// Frees what moving frames keep, where there are none.
  bool isMoving(const scene::Snapshot& snapshot) {
    const bool picks = snapshot.lightSampling.mode == scene::LightSampling::Mode::surfaces ||
                       snapshot.lightSampling.mode == scene::LightSampling::Mode::points;
    if (!render::hasLight(snapshot) && !picks) histories_.clear(), paces_.clear();
    if (paces_.size() > kMaxPaces) paces_.clear();  // windows come and go
    return render::hasLight(snapshot) && snapshot.lightSampling.mode == scene::LightSampling::Mode::moving;
  }

  /// The factor for lit surfaces. Parts of a view that other processes have are not measured.
  float exposureOf(const scene::Snapshot& snapshot, const render::TraceOptions& options) {
    if (!render::wantsMeter(snapshot)) return 1;
    if (options.remote) {
      log::once(log::Level::warning, "auto-exposure",
                "auto-exposure: this process has a part of the view only; set gather, or exposure");
      return 1;
    }
    const timeline::Span span("meter");
    return exposures_.exposureOf(snapshot,
                                 [&] { return render::meteredExposure(snapshot, *world_, *arena_); });
  }

  static constexpr size_t kMaxPaces = 64;

  void prepareArena(int threads) {
    if (threads_ == Threads::shared)
      arena_ = arenaFor(ArenaUse::frames, threads);
    else if (!arena_)
      arena_ = std::make_shared<Arena>(threads);
  }

  const Threads threads_;
  render::FxaaMemory fxaaMemory_;
  std::shared_ptr<Arena> arena_;
  std::optional<accel::World> world_;
  render::Media media_;
  render::VolumeLights volumeLights_;
  uint64_t contextsGone_ = 0;  // g_contextsGone when orphans were released
  // Of moving frames, by view; none while light is off.
  render::LightHistories histories_;
  std::map<uint64_t, Pace> paces_;
  ViewExposures exposures_;
};

/// Locks the engine before calls behind all others.
class Renderer::InFront {
 public:
  explicit InFront(Engine& engine) : engine_(engine) {
    ++engine_.wanted;
    engine_.mutex.lock();
  }
  ~InFront() {
    engine_.mutex.unlock();
    --engine_.wanted;
  }
  InFront(const InFront&) = delete;
  InFront& operator=(const InFront&) = delete;

 private:
  Engine& engine_;
};

Renderer::Renderer(Threads threads) : engine_(std::make_unique<Engine>(threads)) {}
Renderer::~Renderer() = default;

namespace {

/// Runs `body`, where its stack is ample; false, with the reason in `error` and the loss in `cost`, if it
/// throws.
template <class Body>
bool caught(scene::TraceCost& cost, std::string& error, const Body& body) noexcept {
  const char* reason = "unknown failure while tracing";
  try {
    onAmpleStack(body);
    return true;
  } catch (const std::bad_alloc&) {
    cost.loss = scene::Loss::frames;
    reason = "out of memory while tracing";
  } catch (const std::exception& e) {
    cost.loss = scene::lossOf(e);
    try {
      error = e.what();
      return false;
    } catch (...) { reason = "out of memory while tracing"; }
  } catch (...) { cost.loss = scene::Loss::tracing; }
  try {
    error = reason;
  } catch (...) {  // out of memory: leave the error line empty
  }
  return false;
}

}  // namespace

bool Renderer::render(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                      std::string& error) noexcept {
  return caught(cost, error, [&] {
    const InFront lock(*engine_);
    engine_->render(snapshot, image, cost);
  });
}

bool Renderer::renderBehind(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                            std::string& error, const std::function<bool()>& stop) noexcept {
  bool whole = false;
  error.clear();
  const bool done = caught(cost, error, [&] {
    const std::unique_lock lock(engine_->mutex, std::try_to_lock);
    if (!lock) return;
    const auto interrupt = [&] { return engine_->wanted > 0 || stop(); };
    render::TraceOptions options;
    options.interrupt = interrupt;
    whole = !interrupt() && engine_->render(snapshot, image, cost, options);
  });
  return done && whole;
}

bool Renderer::renderTiles(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                           std::string& error, render::TileSource& source, bool averages) noexcept {
  return caught(cost, error, [&] {
    const InFront lock(*engine_);
    render::TraceOptions options;
    options.source = &source, options.averages = averages;
    engine_->render(snapshot, image, cost, options);
  });
}

bool Renderer::renderMoving(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                            std::string& error, render::MovingTileSource& source, bool averages,
                            const render::MovingRays& rays) noexcept {
  return caught(cost, error, [&] {
    const InFront lock(*engine_);
    render::TraceOptions options;
    options.source = &source, options.movingSource = &source;
    options.averages = averages, options.rays = rays;
    engine_->render(snapshot, image, cost, options);
  });
}

bool Renderer::renderPart(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                          std::string& error, render::MovingTileSource& source, bool averages,
                          render::RemoteSurfaces& remote) noexcept {
  return caught(cost, error, [&] {
    const InFront lock(*engine_);
    render::TraceOptions options;
    options.source = &source, options.movingSource = &source;
    options.averages = averages, options.remote = &remote;
    engine_->render(snapshot, image, cost, options);
  });
}

std::shared_ptr<const render::SampleIllumination> Renderer::illuminate(
    const scene::Snapshot& snapshot) noexcept {
  std::shared_ptr<const render::SampleIllumination> found;
  scene::TraceCost cost;
  std::string error;
  if (!caught(cost, error, [&] {
        const InFront lock(*engine_);
        found = engine_->illuminate(snapshot);
      }))
    log::once(log::Level::warning, "volume light", "a volume gets no light: " + error);
  return found;
}

bool Renderer::improves() const noexcept {
  const std::unique_lock lock(engine_->mutex, std::try_to_lock);
  return lock && engine_->improves();
}

bool Renderer::antialias(const Settings& settings, const scene::Fxaa& fxaa, const uint32_t* in, int width,
                         int height, uint32_t* out) noexcept {
  try {
    const InFront lock(*engine_);
    engine_->antialias(settings, fxaa, in, width, height, out);
    return true;
  } catch (...) { return false; }
}

bool Renderer::resolve(const Settings& settings, const scene::Resolve& how, const Image& samples,
                       Image& out) noexcept {
  try {
    const InFront lock(*engine_);
    engine_->resolve(settings, how, samples, out);
    return true;
  } catch (...) { return false; }
}

}  // namespace gluray::frame
