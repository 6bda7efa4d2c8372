#include "gl/window/window_frames.h"

#include "base/clock.h"
#include "base/timeline.h"
#include "gl/batch/clears.h"
#include "gl/layers/layer_draws.h"
#include "gl/pending/address_space_gate.h"
#include "gl/real/draw_binding.h"
#include "gl/real/errors.h"
#include "gl/real/state_queries.h"

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
    if (presented_.waiting) settle();  // if no image waits, the batch hides what the back buffer lacks
    if (p_.pending.batch.empty() || !p_.cleared.target()) return false;  // tracing has failed
    // The pixel value of a clear is read from the back buffer.
    if (!p_.pending.presenter.window().knowsClear(*p_.cleared.target())) makeClear();
    const float depthResolution = p_.shadow.target().depthResolution;
    timeline::writeIfDue();
    const timeline::Span span("batch", p_.pending.batch.waiting().instances.size());
    {
      const FlushPurpose showing(p_.clock, &FrameClock::shows);
      p_.pending.attachSecondaryScene();
    }
    const ShowTarget target{*p_.cleared.target(),
                            farthestHit(p_.pending.batch.key().depthFunc, depthResolution),
                            p_.shadow.info.core, p_.clock.wish(), show};
    p_.shadow.current.shelve(p_.shadow.real);
    const PresentResult result =
        p_.pending.presenter.window().show(p_.shadow.real, p_.pending.batch.pending(), target);
    if (result.outcome != PresentResult::traced) {  // the batch stays pending, and its traced image is known
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

LagRefusal WindowFrames::whyNotLag(GLenum buffer) const {
  if (p_.pending.batch.empty())
    return p_.clock.passesThrough() ? LagRefusal::measured : LagRefusal::nothingToDo;
  const BatchKey& key = p_.pending.batch.key();
  const bool right = key.drawBuffer == buffer || (buffer == GL_BACK && key.drawBuffer == GL_BACK_LEFT);
  if (key.framebuffer != 0 || !right || key.samples > 1 || !key.colorWrites.all() || key.encodes)
    return LagRefusal::target;
  if (p_.clock.passesThrough() || p_.clock.measured()) return LagRefusal::measured;
  // Kept draws of programs refer to textures and buffers by name, and other contexts may change these.
  if (p_.shadow.activeQueries > 0 || key.layers != BatchKey::Layers::none || p_.layers.held.pending() ||
      p_.pending.unresolved.waiting ||
      (!p_.pending.batch.programDraws().empty() && p_.shadow.group.contexts > 1))
    return LagRefusal::state;
  return p_.failsafe.aside() || p_.shadow.info.off || addressSpaceIsShort() ? LagRefusal::failure
                                                                            : LagRefusal::none;
}

void WindowFrames::noteBegin() {
  if (p_.clock.beganSeconds == 0) p_.clock.beganSeconds = nowSeconds();
}

LagRefusal WindowFrames::lag(const LagWindow& window) noexcept {
  LagRefusal refusal = LagRefusal::failure;
  p_.failsafe.protect([&] {
    settle();
    refusal = whyNotLag(window.overdue.buffer);
    if (refusal != LagRefusal::none) return;
    p_.shadow.errors.keepPending();
    p_.pending.attachSecondaryScene();
    LaggedFrame frame{{}, window, {}, 1, {}};
    const GLenum depthFunc = p_.pending.batch.key().depthFunc;
    const glm::ivec2 size = window.overdue.size;
    if (window.show && mayShowDirectly() && contains(p_.cleared.target()->region, {0, 0, size.x, size.y})) {
      frame.cleared = p_.cleared.target();
      frame.farthest = farthestHit(depthFunc, p_.shadow.target().depthResolution);
    }
    refusal =
        p_.pending.presenter.window().traceAhead(p_.shadow.real, p_.pending.batch.pending(),
                                                 {depthFunc, frame.cleared, frame.farthest, window.overdue});
    if (refusal != LagRefusal::none) return;
    frame.batch = p_.pending.hold("ahead");
    lagged_ = std::move(frame);
    p_.shadow.real.Flush();  // lets the frame's rasterised draws start
  });
  return refusal;
}

/// Shows the frame without the back buffer, if that contained only a clear and the next frame begins with a
/// clear. Returns false if the frame was not shown.
bool WindowFrames::showsDirectly(const LaggedFrame& frame) {
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if (!frame.cleared || frame.clears.empty() || (frame.clears.front().mask & kBoth) != kBoth) return false;
  p_.shadow.current.shelve(p_.shadow.real);
  const PresentResult result = p_.pending.presenter.window().show(
      p_.shadow.real, frame.batch.snapshot,
      {*frame.cleared, frame.farthest, p_.shadow.info.core, {}, frame.window.show});
  if (result.outcome != PresentResult::traced) return p_.shadow.latch.restore(p_.shadow.real), false;
  p_.pending.takeResult(result);
  noteUse(Quirk::softwareShow);
  return true;
}

PresentResult WindowFrames::presentLagged(LaggedFrame& frame) {
  const PresentResult result = p_.pending.presenter.present(p_.shadow.real, frame.batch.snapshot,
                                                            {.depthFunc = frame.batch.key.depthFunc,
                                                             .core = p_.shadow.info.core,
                                                             .programDraws = std::move(frame.batch.draws)});
  p_.pending.takeResult(result);
  frame.window.swap();
  return result;
}

void WindowFrames::showLagged() {
  if (!lagged_) return;
  noteBegin();
  const timeline::Span span("show lagged", lagged_->batch.snapshot->instances.size());
  LaggedFrame frame = std::move(*lagged_);
  lagged_.reset();
  const double start = p_.counts.kinds() ? nowSeconds() : 0;
  PresentResult result;
  if (!frame.window.stands()) {
    p_.pending.presenter.window().dropAhead();
    result.outcome = PresentResult::traced;  // the window is gone: no failure
  } else if (!showsDirectly(frame)) {
    result = presentLagged(frame);
  } else {
    result.outcome = PresentResult::traced;
  }
  for (const WindowClear& clear : frame.clears)
    if (const GLenum pending = p_.pending.presenter.window().clear(p_.shadow.real, clear))
      p_.shadow.errors.set(pending);
  if (p_.counts.kinds()) [[unlikely]]
    p_.counts.kinds()->exclude(nowSeconds() - start);
  if (result.outcome != PresentResult::traced) p_.failsafe.fail(result.loss(), result.reason());
}

bool WindowFrames::clearsLater(GLbitfield mask) {
  constexpr size_t kMaxClears = 8;
  noteBegin();
  p_.pending.stopRefining();
  if (!lagged_ && !lacks()) return false;
  if (!p_.pending.batch.empty() || mask == 0 || mask & ~kClears || p_.clock.passesThrough() ||
      p_.failsafe.aside() || p_.clock.startsMeasuring() || p_.shadow.activeQueries > 0 ||
      !clearsWindow(p_.shadow.real, p_.shadow.rare(), mask))
    return false;
  if (!lagged_) return holdsClear(mask);
  if (lagged_->clears.size() >= kMaxClears) return false;
  lagged_->clears.push_back(windowClear(p_.shadow.real, mask));
  return true;
}

}  // namespace gluray::gl
