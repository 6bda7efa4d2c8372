#include "gl/batch/flusher.h"

#include "base/clock.h"
#include "base/log.h"
#include "base/process_exit.h"
#include "base/timeline.h"
#include "gl/batch/address_space_gate.h"
#include "gl/batch/resolve_draws.h"
#include "gl/errors.h"
#include "gl/layers/layer_draws.h"
#include "gl/state/draw_binding.h"
#include "gl/window/composed_views.h"
#include "gl/window/window_frames.h"

#include <GL/glext.h>

#include <bit>
#include <cmath>
#include <string>
#include <utility>

namespace gluray::gl {
namespace {

/// Why the draws of a batch that could not be traced were rasterised.
Reason reasonOf(scene::Loss loss) {
  switch (loss) {
    case scene::Loss::draws: return Reason::untraceable;
    case scene::Loss::frames: return Reason::shortage;
    default: return Reason::failure;
  }
}

constexpr const char* kShort = "limits of the process (ulimit -v, -d) leave too little for OpenGL";

}  // namespace

bool Flusher::canTrace() {
  if (supported_) return *supported_;
  std::string why;
  supported_ = presenter.supports(p_.shadow.real, p_.shadow.info.core, why);
  if (!*supported_)
    log::once(log::Level::warning, "support",
              "this OpenGL cannot show traced pictures (" + why + "): the program draws as without GLuRay");
  return *supported_;
}

scene::LightSampling::Mode Flusher::begin() {
  p_.window.stopRefining();
  return p_.clock.lightMode(p_.shadow.settings);
}

void Flusher::flushBatch() {
  if (p_.layers.holdsDepths()) p_.layers.giveUp();
  present();
  if (p_.layers.asks()) p_.layers.giveUp();
}

void Flusher::present(Reason reason) {
  p_.window.showLagged();
  pictured.collect(batch);
  if (batch.empty()) return;
  const bool isShort = reason == Reason::traced && addressSpaceIsShort();
  presentBatch(isShort ? Reason::shortage : reason);
  if (isShort) p_.failsafe.fail(scene::Loss::frames, kShort);
}

void Flusher::presentBatch(Reason reason) {
  timeline::writeIfDue();
  const timeline::Span span("batch", batch.waiting().instances.size());
  const BatchKey key = batch.key();
  if (key.framebuffer == 0) p_.window.makeClear();
  const bool factors = key.layers == BatchKey::Layers::factors;
  if (factors && reason != Reason::traced) return void(batch.take());  // the real OpenGL has drawn them
  const bool peeled = key.layers == BatchKey::Layers::peeled;
  if (peeled && (reason == Reason::shortage || !p_.layers.haveSurfaces())) return p_.layers.giveUp();
  if (key.layers == BatchKey::Layers::drawn && reason == Reason::traced && !p_.layers.readUnder())
    reason = Reason::framebuffer;
  const bool rasterise = reason != Reason::traced;
  if (!rasterise) surround();
  const scene::SnapshotPtr snapshot = batch.take();
  const double start = p_.counts.kinds() ? nowSeconds() : 0;
  if (p_.counts.decisions()) [[unlikely]]
    p_.counts.decisions()->batch(key, snapshot->instances.size(), reason);
  p_.shadow.syncCurrent();
  p_.surfaces.passes.flushed(rasterise || factors ? nullptr : snapshot);
  if (rasterise) p_.counts.asRasterised(*snapshot, reason);
  const std::optional<ClearedTarget> under = rasterise ? std::nullopt : p_.cleared.under(*snapshot, key);
  const AntialiasedPicture antialiased = p_.cleared.antialiased();
  p_.cleared.forget();
  if (!rasterise) p_.composed.presenting(key, *snapshot);
  const PresentResult result = peeled ? p_.layers.present(snapshot, key)
                                      : presenter.present(p_.shadow.real, snapshot,
                                                          {.depthFunc = key.depthFunc,
                                                           .core = p_.shadow.info.core,
                                                           .rasterise = rasterise,
                                                           .programDraws = batch.takeProgramDraws(),
                                                           .wish = p_.clock.wish(),
                                                           .cleared = under});
  if (result.outcome == PresentResult::traced && !rasterise) p_.surfaces.traced(key, snapshot);
  if (!rasterise) p_.composed.presented(key, snapshot, result.outcome == PresentResult::traced);
  p_.cleared.wrote(key.framebuffer, result.uploaded);
  if (result.averages) p_.cleared.wroteAntialiased(antialiased, key);
  p_.resolves.cleanIs({});
  p_.shadow.latch.restore(p_.shadow.real);
  takeResult(result);
  if (p_.counts.kinds()) [[unlikely]]
    p_.counts.kinds()->exclude(nowSeconds() - start);
  const bool declined = result.layers && result.outcome == PresentResult::rasterised;
  if (declined) p_.counts.asRasterised(*snapshot, Reason::programPass);
  const auto wanted = rasterise || declined ? PresentResult::rasterised : PresentResult::traced;
  if (result.outcome == wanted) return;
  if (!rasterise && !factors) p_.counts.asRasterised(*snapshot, reasonOf(result.loss()));
  p_.failsafe.fail(result.loss(), result.reason());
}

void Flusher::takeResult(const PresentResult& result, bool known) {
  if (result.pendingError != GL_NO_ERROR) p_.shadow.errors.set(result.pendingError);
  p_.clock.drawn();
  if (p_.counts.decisions()) [[unlikely]]
    p_.counts.decisions()->presented(result, known);
  Statistics& statistics = p_.counts.statistics;
  statistics.presentSeconds += result.presentSeconds;
  if (!known) {
    ++statistics.flushes;
    // Windows are made before they are drawn into; later windows meet a later power of two.
    if (std::has_single_bit(uint64_t{statistics.flushes})) watchForExit();
  }
  if (!known && result.repeated) ++statistics.repeated;
  statistics.lightPasses += result.passes;
  if (std::isfinite(result.noise)) statistics.lightNoise = result.noise;
  statistics.buildSeconds += result.cost.buildSeconds;
  statistics.traceSeconds += result.cost.traceSeconds;
  statistics.blasBuilds += result.cost.blasBuilds;
  statistics.blasRefinements += result.cost.blasRefinements;
  if (known && result.repeated) return;
  if (!result.repeated) statistics.bvhBytes = result.cost.bvhBytes;  // repeated pictures do not report it
  statistics.blasRefining = result.cost.blasRefining;
}

void Flusher::settle() {
  p_.composed.settle();
  p_.window.settle();
  p_.resolves.settle();
}

void Flusher::settleBelow(int samples) {
  if (p_.resolves.waits() && samples > 1) settle();
  p_.window.settleBelow();
}

void Flusher::leave() {
  p_.composed.settle();
  p_.window.showLagged();
  pictured.collect(batch);
  if (!batch.empty() && !p_.resolves.hold()) present();
}

UnresolvedPicture::Cleared Flusher::beforeClear(GLbitfield mask) {
  p_.composed.settle();
  p_.window.stopRefining();
  const UnresolvedPicture::Cleared clean = p_.resolves.clearedBy(mask);
  present();
  p_.window.clears(mask);
  p_.resolves.clears(clean);
  return clean;
}

void Flusher::beforeBlit() noexcept {
  p_.failsafe.protect([&] {
    p_.shadow.syncCurrent();
    flushBatch();
    p_.resolves.meetBlit();
    p_.composed.settle();
    p_.window.settle();
    p_.shadow.sendBuffers();
  });
}

void Flusher::presentLate(const BatchKey& key, const scene::SnapshotPtr& snapshot,
                          std::vector<ProgramDraw> draws, bool known) {
  const RealGl& real = p_.shadow.real;
  const bool isShort = addressSpaceIsShort();
  const PresentResult result = [&] {
    const DrawBinding binding(real, key.framebuffer);
    return presenter.present(real, snapshot,
                             {.depthFunc = key.depthFunc,
                              .core = p_.shadow.info.core,
                              .rasterise = isShort,
                              .programDraws = std::move(draws),
                              .wish = known ? p_.clock.wishAsShown() : p_.clock.wish()});
  }();
  p_.shadow.latch.restore(real);
  takeResult(result, known);
  if (result.outcome == PresentResult::traced) return;
  const bool costsFrames = isShort && result.outcome == PresentResult::rasterised;
  const scene::Loss loss = costsFrames ? scene::Loss::frames : result.loss();
  p_.counts.asRasterised(*snapshot, reasonOf(loss));
  p_.failsafe.fail(loss, costsFrames ? kShort : result.reason());
}

void Flusher::imagesChange() noexcept {
  if (p_.layers.asks() || batch.readsImages() || p_.resolves.waits() || p_.window.readsImages())
    p_.failsafe.protect([&] { flush(); });
}

void Flusher::contentsChange(GLuint buffer) noexcept {
  if (p_.resolves.readsBuffer(buffer) || p_.window.readsBuffer(buffer) || batch.readsBuffer(buffer))
    p_.failsafe.protect([&] { flush(); });
}

}  // namespace gluray::gl
