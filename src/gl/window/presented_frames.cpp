// Pictures that are shown without the back buffer.
#include "base/timeline.h"
#include "gl/context.h"
#include "gl/state/state_queries.h"
#include "gl/window/clears.h"
#include "gl/window/window_frames.h"

#include <GL/glext.h>

#include <utility>

namespace gluray::gl {
namespace {

constexpr int kMostInVain = 3, kPause = 120;  // frames

}  // namespace

bool WindowFrames::mayShowDirectly() noexcept {
  return c_.protect([&] {
    c_.immediate.closeRunIfOpen();
    if (c_.batch().empty() || !c_.clearedTarget() || c_.clearedTarget()->framebuffer != 0) return false;
    if (shown_.pause > 0) return --shown_.pause, false;
    const BatchKey& key = c_.batch().key();
    return key.framebuffer == 0 && key.drawBuffer == GL_BACK && key.samples == 1 &&
           key.layers == BatchKey::Layers::none && (key.depthFunc == GL_LEQUAL || key.depthFunc == GL_LESS) &&
           !c_.batch().waiting().wideColors && key.colorWrites.all() &&
           contains(c_.clearedTarget()->region, c_.batch().waiting().region) && !c_.passthrough() &&
           !c_.insideBegin() && !c_.aside() && !c_.direct() && c_.activeQueries == 0;
  });
}

bool WindowFrames::showDirectly(glm::ivec2 window, const ShowPicture& show) noexcept {
  return c_.protect([&] {
    if (!contains(c_.clearedTarget()->region, {0, 0, window.x, window.y})) return false;
    settle();
    c_.refresh(kTarget);
    timeline::writeIfDue();
    const timeline::Span span("batch", c_.batch().waiting().instances.size());
    const BatchKey key = c_.batch().key();
    c_.syncCurrent();
    const ShowTarget target{*c_.clearedTarget(), farthestHit(key.depthFunc, c_.state.target.depthResolution),
                            c_.info().core, !c_.measured(), show};
    const PresentResult result = c_.presenter().window().show(c_.real, c_.batch().pending(), target);
    c_.latch.restore(c_.real);
    if (result.outcome != PresentResult::traced) {  // it waits still; what was traced is known
      c_.statistics.buildSeconds += result.cost.buildSeconds;
      c_.statistics.traceSeconds += result.cost.traceSeconds;
      shown_.pause = kPause;
      return false;
    }
    c_.takeResult(result);
    Shown::Waiting waiting{key, c_.batch().take(), c_.batch().takeProgramDraws()};
    c_.passes.flushed(waiting.snapshot);
    shown_.waiting = std::move(waiting);
    c_.forgetClear();
    noteUse(Quirk::softwareShow);
    return true;
  });
}

void WindowFrames::clears(GLbitfield mask) {
  if (!shown_.waiting) return;
  if (c_.state.rare.framebufferObjects && integer(c_.real, GL_DRAW_FRAMEBUFFER_BINDING) != 0) return;
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if ((mask & kBoth) != kBoth || isOn(c_.real, GL_SCISSOR_TEST) || !clearsAll(c_.real, c_.state.rare))
    return settle();
  shown_.waiting.reset();
  shown_.inVain = 0;
}

void WindowFrames::settle() {
  showLagged();
  if (!shown_.waiting) return;
  Shown::Waiting waiting = std::move(*shown_.waiting);
  shown_.waiting.reset();
  if (++shown_.inVain >= kMostInVain) shown_.inVain = 0, shown_.pause = kPause;
  c_.presentLate(waiting.key, waiting.snapshot, std::move(waiting.draws), true);
}

void WindowFrames::settleBelow() {
  if (!shown_.waiting) return;
  c_.refresh(kTarget);
  if (c_.state.target.framebuffer == 0) settle();
}

bool WindowFrames::readsImages() const {
  return (shown_.waiting && gl::readImages(shown_.waiting->draws)) ||
         (lagged_ && gl::readImages(lagged_->draws));
}

bool WindowFrames::readsBuffer(GLuint buffer) const {
  return (shown_.waiting && gl::readsBuffer(shown_.waiting->draws, buffer)) ||
         (lagged_ && gl::readsBuffer(lagged_->draws, buffer));
}

}  // namespace gluray::gl
