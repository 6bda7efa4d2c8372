// Pictures that are shown without the back buffer: the Context's side of Shown.
#include "base/timeline.h"
#include "gl/clears.h"
#include "gl/context.h"
#include "gl/state_queries.h"

#include <GL/glext.h>

#include <utility>

namespace gluray::gl {
namespace {

constexpr int kMostInVain = 3, kPause = 120;  // frames

}  // namespace

bool Context::mayShowDirectly() noexcept {
  return protect([&] {
    immediate.closeRunIfOpen();
    if (batch_.empty() || !cleared_ || cleared_->framebuffer != 0) return false;
    if (shown_.pause > 0) return --shown_.pause, false;
    const BatchKey& key = batch_.key();
    return key.framebuffer == 0 && key.drawBuffer == GL_BACK && key.samples == 1 &&
           key.layers == BatchKey::Layers::none && (key.depthFunc == GL_LEQUAL || key.depthFunc == GL_LESS) &&
           !batch_.waiting().wideColors && contains(cleared_->region, batch_.waiting().region) &&
           !passthrough_ && !insideBegin() && !aside_ && !direct_ && activeQueries == 0;
  });
}

bool Context::showDirectly(glm::ivec2 window, const ShowPicture& show) noexcept {
  return protect([&] {
    if (!contains(cleared_->region, {0, 0, window.x, window.y})) return false;
    settleShown();
    refresh(kTarget);
    timeline::writeIfDue();
    const timeline::Span span("batch", batch_.waiting().instances.size());
    const BatchKey key = batch_.key();
    syncCurrent();
    const ShowTarget target{*cleared_, farthestHit(key.depthFunc, state.target.depthResolution), info_.core,
                            !measured(), show};
    const PresentResult result = presenter_.show(real, batch_.pending(), target);
    latch.restore(real);
    if (result.outcome != PresentResult::traced) {  // it waits still; what was traced is known
      statistics.buildSeconds += result.buildSeconds;
      statistics.traceSeconds += result.traceSeconds;
      shown_.pause = kPause;
      return false;
    }
    takeResult(result);
    Shown::Waiting waiting{key, batch_.take(), batch_.takeProgramDraws()};
    passes_.flushed(waiting.snapshot);
    shown_.waiting = std::move(waiting);
    forgetClear();
    noteUse(Quirk::softwareShow);
    return true;
  });
}

void Context::clearsShown(GLbitfield mask) {
  if (!shown_.waiting) return;
  if (state.rare.framebufferObjects && integer(real, GL_DRAW_FRAMEBUFFER_BINDING) != 0) return;
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if ((mask & kBoth) != kBoth || isOn(real, GL_SCISSOR_TEST) || !clearsAll(real, state.rare))
    return settleShown();
  shown_.waiting.reset();
  shown_.inVain = 0;
}

void Context::settleShown() {
  showLagged();
  if (!shown_.waiting) return;
  Shown::Waiting waiting = std::move(*shown_.waiting);
  shown_.waiting.reset();
  if (++shown_.inVain >= kMostInVain) shown_.inVain = 0, shown_.pause = kPause;
  presentLate(waiting.key, waiting.snapshot, std::move(waiting.draws), true);
}

void Context::settleShownBelow() {
  if (!shown_.waiting) return;
  refresh(kTarget);
  if (state.target.framebuffer == 0) settleShown();
}

}  // namespace gluray::gl
