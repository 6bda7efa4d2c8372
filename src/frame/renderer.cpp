#include "frame/renderer.h"

#include "accel/world.h"
#include "base/clock.h"
#include "base/timeline.h"
#include "frame/pace.h"
#include "parallel/arena.h"
#include "render/film/fxaa.h"
#include "render/film/resolve.h"
#include "render/float_guard.h"
#include "render/tile_tracer.h"
#include "scene/effects.h"

#include <map>
#include <mutex>
#include <optional>

namespace gluray::frame {

/// State kept between frames. Each part is made at its first use, and again if that failed.
class Renderer::Engine {
 public:
  std::mutex mutex;

  void render(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost) {
    cost = {};
    if (snapshot.settings.renderer == gluray::Renderer::null) return render::clearImage(snapshot, image);

    const render::FloatGuard guard;
    const double start = nowSeconds();
    prepareArena(snapshot.settings.threads);
    if (!world_) world_.emplace();
    const accel::UpdateStatistics update = [&] {
      const timeline::Span span("build", snapshot.instances.size());
      return world_->update(snapshot, *arena_);
    }();
    cost.blasBuilds = update.blasBuilds;
    cost.tlasBuilds = update.tlasBuilds;
    cost.blasRefinements = update.blasRefinements;
    cost.bvhBytes = world_->bytes();
    cost.blasRefining = world_->refining();
    const bool moves = isMoving(snapshot);
    const double built = nowSeconds();
    cost.buildSeconds = built - start;
    {
      const timeline::Span span("trace");
      const render::MovingRays rays = moves ? paces_[snapshot.view].rays() : render::MovingRays();
      render::traceImage(snapshot, *world_, *arena_, image, {&histories_, rays});
    }
    cost.traceSeconds = nowSeconds() - built;
    if (moves) paces_[snapshot.view].took(cost.traceSeconds, 1 / static_cast<double>(snapshot.settings.fps));
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
    if (!render::hasLight(snapshot)) histories_.clear(), paces_.clear();
    if (paces_.size() > kMostPaces) paces_.clear();  // windows come and go
    return render::hasLight(snapshot) && snapshot.lightSampling.mode == scene::LightSampling::Mode::moving;
  }

  static constexpr size_t kMostPaces = 64;

  void prepareArena(int threads) { arena_ = arenaFor(ArenaUse::frames, threads); }

  render::FxaaMemory fxaaMemory_;
  std::shared_ptr<Arena> arena_;
  std::optional<accel::World> world_;
  // Of moving frames, by view; none while light is off.
  render::LightHistories histories_;
  std::map<uint64_t, Pace> paces_;
};

Renderer::Renderer() : engine_(std::make_unique<Engine>()) {}
Renderer::~Renderer() = default;

Renderer& Renderer::shared() {
  static auto* renderer = new Renderer;
  return *renderer;
}

bool Renderer::render(const scene::Snapshot& snapshot, Image& image, scene::TraceCost& cost,
                      std::string& error) noexcept {
  const char* reason = "unknown failure while tracing";
  try {
    const std::lock_guard lock(engine_->mutex);
    engine_->render(snapshot, image, cost);
    return true;
  } catch (const std::bad_alloc&) {
    reason = "out of memory while tracing";
  } catch (const std::exception& e) {
    try {
      error = e.what();
      return false;
    } catch (...) { reason = "out of memory while tracing"; }
  } catch (...) {}
  try {
    error = reason;
  } catch (...) {  // out of memory: leave the error line empty
  }
  return false;
}

bool Renderer::improves() const noexcept {
  const std::unique_lock lock(engine_->mutex, std::try_to_lock);
  return lock && engine_->improves();
}

bool Renderer::antialias(const Settings& settings, const scene::Fxaa& fxaa, const uint32_t* in, int width,
                         int height, uint32_t* out) noexcept {
  try {
    const std::lock_guard lock(engine_->mutex);
    engine_->antialias(settings, fxaa, in, width, height, out);
    return true;
  } catch (...) { return false; }
}

bool Renderer::resolve(const Settings& settings, const scene::Resolve& how, const Image& samples,
                       Image& out) noexcept {
  try {
    const std::lock_guard lock(engine_->mutex);
    engine_->resolve(settings, how, samples, out);
    return true;
  } catch (...) { return false; }
}

}  // namespace gluray::frame
