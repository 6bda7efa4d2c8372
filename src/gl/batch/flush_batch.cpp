// From the pending batch to the framebuffer: when, and what comes of it.
#include "base/clock.h"
#include "base/log.h"
#include "base/timeline.h"
#include "gl/context.h"
#include "gl/state/state_queries.h"

#include <GL/gl.h>
#include <GL/glext.h>

#include <exception>
#include <optional>
#include <string>

namespace gluray::gl {

bool Context::canTrace() {
  if (!supportKnown_) {
    supportKnown_ = true;
    std::string why;
    supported_ = presenter_.supports(real, info_.core, why);
    if (!supported_)
      log::once(log::Level::warning, "support",
                "this OpenGL cannot show traced pictures (" + why + "): the program draws as without GLuRay");
  }
  return supported_;
}

void Context::present(Reason reason) {
  window.showLagged();
  if (batch_.empty()) return;
  timeline::writeIfDue();
  const timeline::Span span("batch", batch_.waiting().instances.size());
  const BatchKey key = batch_.key();
  const bool peeled = key.layers == BatchKey::Layers::peeled;
  if (peeled && !layers.haveSurfaces()) return layers.giveUp();
  if (key.layers == BatchKey::Layers::drawn && reason == Reason::traced && !layers.readUnder())
    reason = Reason::framebuffer;
  const bool rasterise = reason != Reason::traced;
  const scene::SnapshotPtr snapshot = batch_.take();
  const double start = kinds() ? nowSeconds() : 0;
  syncCurrent();
  passes.flushed(rasterise ? nullptr : snapshot);
  if (rasterise) countAsRasterised(*snapshot, reason);
  const std::optional<ClearedTarget> under = rasterise ? std::nullopt : clearedUnder(*snapshot, key);
  const Smooth smooth = smooth_;
  forgetClear();
  const PresentResult result = peeled ? layers.present(snapshot, key)
                                      : presenter_.present(real, snapshot,
                                                           {.depthFunc = key.depthFunc,
                                                            .core = info_.core,
                                                            .rasterise = rasterise,
                                                            .programDraws = batch_.takeProgramDraws(),
                                                            .mayRepeat = !measured(),
                                                            .cleared = under});
  if (result.averages) {
    smooth_ = smooth;
    smooth_.wrote(key.framebuffer, key.drawBuffer);
  }
  resolves.cleanIs({});
  latch.restore(real);
  takeResult(result);
  if (kinds()) [[unlikely]]
    kinds()->exclude(nowSeconds() - start);
  const bool declined = result.layers && result.outcome == PresentResult::rasterised;
  if (declined) countAsRasterised(*snapshot, Reason::programPass);
  const auto wanted = rasterise || declined ? PresentResult::rasterised : PresentResult::traced;
  if (result.outcome != wanted)
    stepAside(result.why.empty() ? "the ray tracer could not make a picture" : result.why.c_str());
}

void Context::takeResult(const PresentResult& result, bool known) {
  if (result.pendingError != GL_NO_ERROR) setError(result.pendingError);
  statistics.presentSeconds += result.presentSeconds;
  if (!known) ++statistics.flushes;
  if (!known && result.repeated) ++statistics.repeated;
  statistics.buildSeconds += result.cost.buildSeconds;
  statistics.traceSeconds += result.cost.traceSeconds;
  statistics.blasBuilds += result.cost.blasBuilds;
  statistics.blasRefinements += result.cost.blasRefinements;
  if (known && result.repeated) return;
  if (!result.repeated) statistics.bvhBytes = result.cost.bvhBytes;  // nobody asked for a known picture
  statistics.blasRefining = result.cost.blasRefining;
}

void Context::settle() {
  window.settle();
  resolves.settle();
}

void Context::settleBelow(int samples) {
  if (resolves.waits() && samples > 1) settle();
  window.settleBelow();
}

void Context::leave() {
  window.showLagged();
  if (!batch_.empty() && !resolves.hold()) present();
}

Unresolved::Cleared Context::beforeClear(GLbitfield mask) {
  const Unresolved::Cleared clean = resolves.clearedBy(mask);
  present();
  window.clears(mask);
  resolves.clears(clean);
  return clean;
}

void Context::beforeBlit() noexcept {
  protect([&] {
    syncCurrent();
    flushBatch();
    resolves.meetBlit();
    window.settle();
    sendBuffers();
  });
}

void Context::presentLate(const BatchKey& key, const scene::SnapshotPtr& snapshot,
                          std::vector<ProgramDraw> draws, bool known) {
  const bool objects = isPresent(real.BindFramebuffer);
  const GLuint bound = objects ? static_cast<GLuint>(integer(real, GL_DRAW_FRAMEBUFFER_BINDING)) : 0;
  if (bound != key.framebuffer) real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, key.framebuffer);
  const PresentResult result = presenter_.present(real, snapshot,
                                                  {.depthFunc = key.depthFunc,
                                                   .core = info_.core,
                                                   .programDraws = std::move(draws),
                                                   .mayRepeat = known || !measured()});
  if (bound != key.framebuffer) real.BindFramebuffer(GL_DRAW_FRAMEBUFFER, bound);
  latch.restore(real);
  takeResult(result, known);
  if (result.outcome != PresentResult::traced)
    stepAside(result.why.empty() ? "the ray tracer could not make a picture" : result.why.c_str());
}

void Context::imagesChange() noexcept {
  if (layers.asks() || batch_.readsImages() || resolves.waits() || window.readsImages())
    protect([&] { flush(); });
}

void Context::contentsChange(GLuint buffer) noexcept {
  if (resolves.readsBuffer(buffer) || window.readsBuffer(buffer) || batch_.readsBuffer(buffer))
    protect([&] { flush(); });
}

static bool isFront(GLenum buffer) {
  return buffer == GL_FRONT || buffer == GL_FRONT_LEFT || buffer == GL_FRONT_AND_BACK || buffer == GL_LEFT;
}

/// glFlush or glFinish of a double-buffered program. Where it never swaps, its frames are what it draws into
/// the front buffer; for reports alone, as others do not end there.
void Context::showFront() {
  if (!info_.frameEnded || statistics.frames > 0) return;
  const uint64_t draws = statistics.drawsTraced + statistics.drawsRasterised;
  if (draws == drawsInFront_) return;
  refresh(kTarget);
  if (state.target.framebuffer != 0 || !isFront(state.target.drawBuffer)) return;
  drawsInFront_ = draws;
  if (info_.frameEnding) info_.frameEnding();
  ++statistics.framesInFront;
  info_.frameEnded();
}

void Context::showIfVisible() {
  syncCurrent();
  if (resolves.waits() && group_->contexts > 1) protect([&] { settle(); });
  if (batch_.empty()) return info_.doubleBuffered ? showFront() : showDrawn();
  // What a framebuffer object holds is seen by nobody but contexts that share its images.
  const bool object = batch_.key().framebuffer != 0;
  if (object ? group_->contexts == 1 : info_.doubleBuffered && !isFront(batch_.key().drawBuffer)) return;
  flush();
  if (object) return;
  if (info_.doubleBuffered) return showFront();
  completeFrame();
  if (info_.frameEnding) info_.frameEnding();
  afterSwap();
  if (info_.frameEnded) info_.frameEnded();
}

void Context::stepAside(const char* why) noexcept {
  try {
    if (!aside_)
      log::write(log::Level::warning,
                 std::string("stepping aside, the program draws as without GLuRay from here on: ") + why);
    aside_ = true;
    // What was held back is drawn by the real OpenGL, in order, so that nothing is missing from the picture.
    flush();
    if (immediate.runOpen() || (compiling() && !immediate.stream().empty())) immediate.surrender();
  } catch (...) {  // nothing more can be done; the real OpenGL goes on without these vertices
  }
  updateAttention();
}

}  // namespace gluray::gl
