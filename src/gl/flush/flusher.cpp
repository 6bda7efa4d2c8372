#include "gl/flush/flusher.h"

#include "base/clock.h"
#include "base/timeline.h"
#include "gl/flush/relighting.h"
#include "gl/flush/resolve_draws.h"
#include "gl/framebuffers/composed_views.h"
#include "gl/layers/layer_draws.h"
#include "gl/pending/address_space_gate.h"
#include "gl/real/errors.h"
#include "gl/window/window_frames.h"

#include <optional>
#include <utility>

namespace gluray::gl {

void Flusher::flushBatch() {
  if (p_.layers.held.holdsDepths()) p_.layers.held.giveUp();
  present();
  if (p_.layers.held.asks()) p_.layers.held.giveUp();
}

void Flusher::present(Reason reason) {
  p_.window.showLagged();
  p_.pending.capturedSurfaces.collect(p_.pending.batch);
  if (p_.pending.batch.empty()) return;
  const bool isShort = reason == Reason::traced && addressSpaceIsShort();
  presentBatch(isShort ? Reason::shortage : reason);
  if (isShort) p_.failsafe.fail(scene::Loss::frames, kAddressSpaceIsShort);
}

void Flusher::presentBatch(Reason reason) {
  timeline::writeIfDue();
  const timeline::Span span("batch", p_.pending.batch.waiting().instances.size());
  const BatchKey key = p_.pending.batch.key();
  if (key.framebuffer == 0) p_.window.makeClear();
  const bool isVisibility = key.layers == BatchKey::Layers::visibility;
  if (isVisibility && reason != Reason::traced)
    return void(p_.pending.batch.takeSnapshot());  // the real OpenGL has drawn them
  const bool peeled = key.layers == BatchKey::Layers::peeled;
  if (peeled && (reason == Reason::shortage || !p_.layers.peels.haveSurfaces()))
    return p_.layers.held.giveUp();
  if (key.layers == BatchKey::Layers::drawn && reason == Reason::traced && !p_.layers.drawn.readUnder())
    reason = Reason::framebuffer;
  const bool rasterise = reason != Reason::traced;
  if (!rasterise) p_.pending.attachSecondaryScene();
  const scene::SnapshotPtr snapshot = p_.pending.batch.takeSnapshot();
  const double start = p_.counts.kinds() ? nowSeconds() : 0;
  if (p_.counts.decisions()) [[unlikely]]
    p_.counts.decisions()->batch(key, snapshot->instances.size(), describe(reason));
  p_.surfaces.passes.flushed(rasterise || isVisibility ? nullptr : snapshot);
  if (rasterise) p_.counts.asRasterised(*snapshot, reason);
  const std::optional<ClearedTarget> under = rasterise ? std::nullopt : p_.cleared.under(*snapshot, key);
  const AntialiasedImage antialiased = p_.cleared.antialiased();
  p_.cleared.forget();
  if (!rasterise) p_.composed.presenting(key, *snapshot);
  p_.shadow.current.shelve(p_.shadow.real);
  const PresentResult result =
      peeled ? p_.layers.peels.present(snapshot, key)
             : p_.pending.presenter.present(p_.shadow.real, snapshot,
                                            {.depthFunc = key.depthFunc,
                                             .core = p_.shadow.info.core,
                                             .rasterise = rasterise,
                                             .programDraws = p_.pending.batch.takeProgramDraws(),
                                             .wish = p_.clock.wish(),
                                             .cleared = under,
                                             .keepsPixels = !rasterise && isRelightable(key, *snapshot)});
  if (result.outcome == PresentResult::traced && !rasterise) {
    p_.surfaces.traced(key, snapshot);
    if (result.written) p_.surfaces.views.wrote(snapshot, result.written);
  }
  if (!rasterise) p_.composed.presented(key, snapshot, result.outcome == PresentResult::traced);
  p_.cleared.wrote(key.framebuffer, result.uploaded);
  if (result.averages) p_.cleared.wroteAntialiased(antialiased, key);
  p_.resolves.cleanIs({});
  p_.pending.takeResult(result);
  if (p_.counts.kinds()) [[unlikely]]
    p_.counts.kinds()->exclude(nowSeconds() - start);
  const bool declined = result.layers && result.outcome == PresentResult::rasterised;
  if (declined) p_.counts.asRasterised(*snapshot, Reason::programPass);
  const auto wanted = rasterise || declined ? PresentResult::rasterised : PresentResult::traced;
  if (result.outcome == wanted) return;
  if (!rasterise && !isVisibility) p_.counts.asRasterised(*snapshot, reasonOf(result.loss()));
  p_.failsafe.fail(result.loss(), result.reason());
}

void Flusher::settle() { p_.resolves.settleAll(); }

void Flusher::settleBelow(int samples) {
  if (p_.resolves.waits() && samples > 1) settle();
  p_.window.settleBelow();
}

void Flusher::leave() {
  p_.composed.settle();
  p_.window.showLagged();
  p_.pending.capturedSurfaces.collect(p_.pending.batch);
  if (!p_.pending.batch.empty() && !p_.resolves.hold()) present();
}

UnresolvedImage::Cleared Flusher::beforeClear(GLbitfield mask) {
  p_.composed.settle();
  p_.pending.stopRefining();
  const UnresolvedImage::Cleared clean = p_.resolves.clearedBy(mask);
  present();
  const bool shows = (mask & GL_DEPTH_BUFFER_BIT) && !(mask & GL_COLOR_BUFFER_BIT);  // what was drawn so far
  if (shows && !p_.surfaces.views.empty()) p_.relighting.update(p_.shadow.target().framebuffer);
  p_.window.clears(mask);
  p_.resolves.clears(clean);
  return clean;
}

void Flusher::beforeBlit(GLbitfield mask) noexcept {
  p_.failsafe.protect([&] {
    flushBatch();
    p_.resolves.meetBlit();
    p_.composed.settle();
    p_.window.settle();
    if (mask & GL_COLOR_BUFFER_BIT) p_.relighting.finish(Relighting::Place::read);
    p_.shadow.sendBuffers();
  });
}

void Flusher::imagesChange() noexcept {
  if (p_.layers.held.asks() || p_.pending.batch.readsImages() || p_.resolves.waits() ||
      p_.window.readsImages())
    p_.failsafe.protect([&] { flush(); });
}

void Flusher::contentsChange(GLuint buffer) noexcept {
  if (p_.resolves.readsBuffer(buffer) || p_.window.readsBuffer(buffer) ||
      p_.pending.batch.readsBuffer(buffer))
    p_.failsafe.protect([&] { flush(); });
}

}  // namespace gluray::gl
