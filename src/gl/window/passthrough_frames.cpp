// Frames that are left to the real OpenGL: draws go to it as they come, and nothing is read back or kept but
// display lists. The Context's side of EngineChoice.
#include "gl/buffers/buffer.h"
#include "gl/context.h"

namespace gluray::gl {

void Context::startMeasuring() {
  window.showLagged();
  real.Finish();  // what is still drawn belongs to earlier frames
  choice_.start();
}

void Context::completeFrame() {
  if (!choice_.wantsStop()) return;
  real.Finish();
  choice_.stop();
}

void Context::chooseEngine() {
  if (compiling() || insideBegin()) return;
  protect([&] { setDirect(choice_.frameEnded() == EngineChoice::Way::direct && !passthrough_); });
}

void Context::setDirect(bool direct) {
  if (direct == direct_) return;
  window.showLagged();
  settle();
  if (direct) {
    syncCurrent();
    for (const auto& buffer : group_->buffers.all())
      if (buffer) buffer->sendTo(real);
  } else {
    touch(kAllGroups);
    matrixMode = 0;
  }
  direct_ = direct;
  updateAttention();
}

/// Whether the scissor test lets a clear reach all that draws can.
bool Context::clearsViewport() const {
  if (!real.IsEnabled(GL_SCISSOR_TEST)) return true;
  GLint box[4] = {}, viewport[4] = {};
  real.GetIntegerv(GL_SCISSOR_BOX, box), real.GetIntegerv(GL_VIEWPORT, viewport);
  return box[0] <= viewport[0] && box[1] <= viewport[1] && box[0] + box[2] >= viewport[0] + viewport[2] &&
         box[1] + box[3] >= viewport[1] + viewport[3];
}

void Context::clearing(GLbitfield mask) {
  if (!choice_.active()) return;
  constexpr GLbitfield kWhole = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if ((mask & kWhole) == kWhole && statistics.frames == 0 && clearsViewport()) {
    completeFrame();
    chooseEngine();
  } else if (mask & GL_DEPTH_BUFFER_BIT) {
    choice_.layer();
  }
  works();
}

void Context::noteLoad(uint64_t triangles) { choice_.drew(triangles, viewportPixels()); }

bool Context::drawsDirectly(DrawPath path, PrimitiveClass kind, uint64_t triangles) {
  if (window.lags()) protect([&] { window.showLagged(); });
  forgetClear();
  refresh(kinds() ? kViewport | kTarget : kViewport);
  if (kind == PrimitiveClass::surfaces && !choice_.takes(triangles, viewportPixels())) {
    choice_.overflow();
    setDirect(false);
    return false;
  }
  works();
  syncCurrent();
  sendBuffers();
  const Reason why = choice_.active() ? Reason::smallScene : Reason::off;
  countRaster(kind == PrimitiveClass::lines    ? Reason::lines
              : kind == PrimitiveClass::points ? Reason::points
                                               : why,
              path, kind, triangles);
  latch.drawn();
  return true;
}

/// glFlush or glFinish of a single-buffered program for which nothing waits to be traced: it may have read
/// its picture back before, or all of it was rasterised.
void Context::showDrawn() {
  if (!choice_.drawn()) return;
  refresh(kTarget);
  if (state.target.framebuffer != 0) return work() != workForgotten_ ? afterSwap() : void();
  completeFrame();
  if (info_.frameEnding) info_.frameEnding();
  afterSwap();
  if (info_.frameEnded) info_.frameEnded();
}

}  // namespace gluray::gl
