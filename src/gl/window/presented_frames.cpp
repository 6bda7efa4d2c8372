// WindowFrames: images that are shown without the back buffer (ADR 0024).
#include "base/timeline.h"
#include "gl/batch/clears.h"
#include "gl/pending/address_space_gate.h"
#include "gl/real/draw_binding.h"
#include "gl/window/window_frames.h"

#include <GL/glext.h>

#include <utility>

namespace gluray::gl {
namespace {

constexpr int kMaxVainFrames = 3, kPause = 120;  // frames
constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;

}  // namespace

bool WindowFrames::mayShowDirectly() noexcept {
  return p_.failsafe.protect([&] {
    if (p_.pending.batch.empty() || !p_.cleared.target() || p_.cleared.target()->framebuffer != 0)
      return false;
    if (presented_.pause > 0) return --presented_.pause, false;
    const BatchKey& key = p_.pending.batch.key();
    return key.framebuffer == 0 && key.drawBuffer == GL_BACK && key.samples == 1 &&
           key.layers == BatchKey::Layers::none && (key.depthFunc == GL_LEQUAL || key.depthFunc == GL_LESS) &&
           !p_.pending.batch.waiting().wideColors && key.colorWrites.all() &&
           contains(p_.cleared.target()->region, p_.pending.batch.waiting().region) && !p_.shadow.info.off &&
           !p_.failsafe.aside() && !p_.clock.passesThrough() && p_.shadow.activeQueries == 0 &&
           !addressSpaceIsShort();
  });
}

bool WindowFrames::showWithoutSwap(ShownWindow& window, glm::ivec2 size, const ShowImage& show) noexcept {
  return p_.failsafe.protect([&] {
    if (!contains(p_.cleared.target()->region, {0, 0, size.x, size.y})) return false;
    showLagged();
    if (presented_.waiting) settle();  // otherwise the batch hides what the back buffer lacks
    if (p_.pending.batch.empty() || !p_.cleared.target()) return false;  // tracing has failed
    // The pixels of a clear are read from the back buffer.
    if (!p_.pending.presenter.window().knowsClear(*p_.cleared.target())) makeClear();
    const float depthResolution = p_.shadow.target().depthResolution;
    timeline::writeIfDue();
    const timeline::Span span("batch", p_.pending.batch.waiting().instances.size());
    p_.pending.attachSecondaryScene();
    const ShowTarget target{*p_.cleared.target(),
                            farthestHit(p_.pending.batch.key().depthFunc, depthResolution),
                            p_.shadow.info.core, p_.clock.wish(), show};
    const PresentResult result =
        p_.pending.presenter.window().show(p_.shadow.real, p_.pending.batch.pending(), target);
    if (result.outcome != PresentResult::traced) {  // the batch stays pending; the traced image is known
      p_.shadow.latch.restore(p_.shadow.real);
      p_.counts.statistics.buildSeconds += result.cost.buildSeconds;
      p_.counts.statistics.traceSeconds += result.cost.traceSeconds;
      presented_.pause = kPause;
      return false;
    }
    p_.pending.takeResult(result);
    presented_.waiting = p_.pending.hold("in the window");
    presented_.window = &window;
    p_.cleared.forget();
    noteUse(Quirk::softwareShow);
    return true;
  });
}

void WindowFrames::refineWhileIdle(const OpenIdleWindow& open) noexcept {
  const Settings& settings = p_.shadow.settings;
  const bool lit = settings.changesImage() && !p_.failsafe.aside();
  if (!lit && !p_.pending.refines) return;
  p_.pending.refines = lit;
  WindowPresenter& window = p_.pending.presenter.window();
  if (!lit)
    window.refineWhileIdle({});
  else
    window.refineWhileIdle(settings.refine.idle && !lagged_ ? open : [] { return nullptr; });
}

bool WindowFrames::holdsClear(GLbitfield mask) {
  const RealGl& real = p_.shadow.real;
  if ((mask & kBoth) != kBoth || drawFramebuffer(real) != 0 || integer(real, GL_DRAW_BUFFER) != GL_BACK)
    return false;
  WindowClear clear = windowClear(real, mask);
  if (presented_.losesStencil(mask))
    clear.mask |= GL_STENCIL_BUFFER_BIT, clear.stencil = presented_.clear->stencil;
  presented_.hide();
  presented_.clear = clear;
  presented_.window->askSize();
  return true;
}

void WindowFrames::meetNewSize() {
  if (!presented_.waiting || !presented_.window->resized()) return;
  settle();
  presented_.window->swap();
}

void WindowFrames::makeClear() {
  if (!presented_.clear) return;
  if (!presented_.waiting && presented_.window->resized()) presented_.window->swap();
  const WindowClear clear = *presented_.clear;
  presented_.clear.reset();
  const DrawBinding binding(p_.shadow.real, 0);
  if (const GLenum pending = p_.pending.presenter.window().clear(p_.shadow.real, clear))
    p_.shadow.errors.set(pending);
}

void WindowFrames::clears(GLbitfield mask) {
  if (!lacks() || drawFramebuffer(p_.shadow.real) != 0) return;
  meetNewSize();
  if (presented_.losesStencil(mask) || (mask & kBoth) != kBoth || isOn(p_.shadow.real, GL_SCISSOR_TEST) ||
      !clearsAll(p_.shadow.real, p_.shadow.rare()))
    return settle();
  presented_.hide();
}

void WindowFrames::settle() {
  showLagged();
  makeClear();
  if (!presented_.waiting) return;
  HeldBatch waiting = std::move(*presented_.waiting);
  presented_.waiting.reset();
  if (++presented_.inVain >= kMaxVainFrames) presented_.inVain = 0, presented_.pause = kPause;
  p_.pending.presentLate(std::move(waiting), true);
}

void WindowFrames::meetDraw() {
  showLagged();
  settleInWindow();
}

void WindowFrames::settleInWindow() {
  if (!lacks()) return;
  if (p_.shadow.target().framebuffer == 0) settle();
}

bool WindowFrames::readsImages() const {
  return (presented_.waiting && presented_.waiting->readsImages()) ||
         (lagged_ && lagged_->batch.readsImages());
}

bool WindowFrames::readsBuffer(GLuint buffer) const {
  return (presented_.waiting && presented_.waiting->readsBuffer(buffer)) ||
         (lagged_ && lagged_->batch.readsBuffer(buffer));
}

}  // namespace gluray::gl
