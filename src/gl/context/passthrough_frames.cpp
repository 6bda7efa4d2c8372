#include "gl/context/passthrough_frames.h"

#include "gl/buffers/buffer.h"
#include "gl/clock/frame_settings.h"
#include "gl/context/attention.h"
#include "gl/culled/culled_draws.h"
#include "gl/window/window_frames.h"

namespace gluray::gl {

void PassthroughFrames::startMeasuring() {
  p_.window.showLagged();
  p_.shadow.real.Finish();  // unfinished work belongs to earlier frames
  p_.clock.choice.start();
}

void PassthroughFrames::stopMeasuring() {
  p_.culled.endFrame();
  if (!p_.clock.measured()) return;
  p_.shadow.real.Finish();
  p_.clock.choice.stop();
}

void PassthroughFrames::chooseNext() {
  p_.failsafe.protect(
      [&] { set(p_.clock.choice.frameEnded() == EngineChoice::Way::passthrough && !p_.shadow.info.off); });
}

void PassthroughFrames::startAnew(Engine engine) {
  const ContextInfo& info = p_.shadow.info;
  p_.clock.choice =
      EngineChoice({engine, threadsOf(p_.shadow.settings), info.software, info.precedents}, info.clock);
  set(p_.clock.choice.way() == EngineChoice::Way::passthrough && !p_.shadow.info.off);
}

void PassthroughFrames::set(bool passthrough) {
  if (passthrough == p_.clock.passesThrough()) return;
  p_.window.showLagged();
  p_.flusher.settle();
  if (passthrough) {
    for (const auto& buffer : p_.shadow.group.buffers.all())
      if (buffer) buffer->sendTo(p_.shadow.real);
  } else {
    p_.shadow.current.letGo();
    p_.shadow.touch(kAllGroups);
    p_.shadow.matrixMode = 0;
  }
  p_.clock.setPassthrough(passthrough);
  p_.attention.update();
}

bool PassthroughFrames::takes(DrawPath path, PrimitiveClass kind, uint64_t triangles, uint64_t more) {
  if (p_.window.lags()) p_.failsafe.protect([&] { p_.window.showLagged(); });
  p_.cleared.forget();
  p_.shadow.refresh(p_.counts.kinds() ? kViewport | kTarget : kViewport);
  EngineChoice& choice = p_.clock.choice;
  // Nothing (a glBegin whose vertices will follow) is never too large.
  if (triangles > 0 && kind == PrimitiveClass::surfaces &&
      !choice.takes(triangles + more, p_.shadow.viewportPixels())) {
    choice.overflow();
    set(false);
    return false;
  }
  works();
  if (p_.shadow.group.anyBuffersHeldBack()) p_.shadow.sendBuffers();
  const Reason why = choice.active() ? Reason::smallScene : Reason::off;
  p_.counts.rasterised(kind == PrimitiveClass::lines    ? Reason::lines
                       : kind == PrimitiveClass::points ? Reason::points
                                                        : why,
                       path, kind, triangles);
  if (more > 0) p_.counts.load(more);
  p_.shadow.latch.drawn();
  return true;
}

}  // namespace gluray::gl
