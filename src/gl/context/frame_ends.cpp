#include "gl/context/frame_ends.h"

#include "gl/basics/thread_state.h"
#include "gl/batch/clears.h"
#include "gl/context/immediate.h"
#include "gl/context/list_compiler.h"
#include "gl/flush/resolve_draws.h"
#include "gl/real/state_queries.h"

#include <GL/glext.h>

#include <utility>

namespace gluray::gl {
namespace {

constexpr GLbitfield kWhole = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;

bool isFront(GLenum buffer) {
  return buffer == GL_FRONT || buffer == GL_FRONT_LEFT || buffer == GL_FRONT_AND_BACK || buffer == GL_LEFT;
}

/// Whether the scissor box lets a clear cover the viewport.
bool clearsViewport(const RealGl& real) {
  if (!real.IsEnabled(GL_SCISSOR_TEST)) return true;
  GLint box[4] = {}, viewport[4] = {};
  real.GetIntegerv(GL_SCISSOR_BOX, box), real.GetIntegerv(GL_VIEWPORT, viewport);
  return box[0] <= viewport[0] && box[1] <= viewport[1] && box[0] + box[2] >= viewport[0] + viewport[2] &&
         box[1] + box[3] >= viewport[1] + viewport[3];
}

}  // namespace

bool FrameEnds::mayShowDirectly() noexcept {
  return p_.failsafe.protect([&] {
    p_.immediate.closeRunIfOpen();
    return !p_.immediate.insideBegin() && p_.window.mayShowDirectly();
  });
}

LagRefusal FrameEnds::lag(const LagWindow& window) noexcept {
  if (p_.lists.compiling()) return LagRefusal::state;
  if (p_.immediate.insideBegin()) return LagRefusal::failure;
  // Images of the frame that are in the window may have to be lit again before it is shown.
  if (p_.surfaces.views.holdsUnchecked(0)) return LagRefusal::state;
  p_.failsafe.protect([&] { p_.immediate.closeRunIfOpen(); });
  const FlushPurpose showing(p_.clock, &FrameClock::shows);
  return p_.window.lag(window);
}

void FrameEnds::beforeSwap() {
  p_.failsafe.protect([&] {
    p_.immediate.closeRunIfOpen();
    p_.window.settle();
    const FlushPurpose showing(p_.clock, &FrameClock::shows);
    p_.flusher.flushBatch();  // an image that waits to be resolved is not in the window
    p_.relighting.finish(0);
  });
}

void FrameEnds::afterSwap() {
  nextFrame();
  p_.surfaces.passes.clear();
  p_.surfaces.coplanar.clear();
}

void FrameEnds::nextFrame() {
  p_.cleared.forget();  // the back buffer is undefined
  p_.clock.forgetPictures();
  picturesSinceSwap_ = 0;
  hasSwapped_ = hasSwapped_ || draws() != drawsBefore_;
  p_.surfaces.objects.shown(p_.settings.frame());
  ++p_.counts.statistics.frames;
  if (p_.clock.passesThrough()) ++p_.counts.statistics.framesPassedThrough;
  p_.clock.beganSeconds = 0;
  chooseEngine();
  ++p_.clock.frame;
  begun_ = false, drawsBefore_ = draws();
  p_.settings.endFrame();
  p_.failsafe.protect([&] { takeSettings(); });
  p_.surfaces.views.swapped();
  forgetOld();
}

uint64_t FrameEnds::draws() const {
  const Statistics& statistics = p_.counts.statistics;
  return statistics.drawsTraced + statistics.drawsRasterised;
}

void FrameEnds::takeSettings() {
  if (p_.lists.compiling() || p_.immediate.insideBegin()) return;
  const ContextInfo& info = p_.shadow.info;
  DrawnObjects& objects = p_.surfaces.objects;
  const Engine before = engineOf(info, p_.settings.now(), objects.asked());
  const bool looked = objects.checkAsked();
  if (!p_.settings.takeCurrent() && !looked) return;
  const Engine now = engineOf(info, p_.settings.now(), objects.asked());
  if (before == now) return;
  p_.flusher.flush();
  p_.passthrough.startAnew(now);
}

/// In a context that never swaps, frames end when another one of the process does: toolkits draw views in
/// contexts of their own. The next one begins with a clear of colours.
void FrameEnds::endWithOthers(GLbitfield mask) {
  const uint64_t frame = p_.settings.sourceFrame();
  if (frame == sourceFrame_ || !(mask & GL_COLOR_BUFFER_BIT) || p_.counts.statistics.frames > 0) return;
  sourceFrame_ = frame, othersSwap_ = true;
  p_.surfaces.objects.endFrame();
  begun_ = false, drawsBefore_ = draws();
}

/// In a context that does not swap a frame is one picture of the framebuffer that is cleared before the first
/// draw. Others, such as those of peeled layers or shadow maps, may be cleared and read many times while a
/// picture is made. In a context that has swapped, pictures between swaps may be parts of a frame: some must
/// follow each other first.
void FrameEnds::endInMemory(GLbitfield mask) {
  constexpr int kPartsOfFrames = 8;
  Statistics& statistics = p_.counts.statistics;
  if (!begun_ || othersSwap_ || statistics.framesInFront > 0 || !(mask & GL_COLOR_BUFFER_BIT)) return;
  if (draws() == drawsBefore_) return;
  const bool isPicture = p_.clock.hasPicture(firstCleared_) &&
                         p_.shadow.target().framebuffer == firstCleared_ && clearsViewport(p_.shadow.real);
  if (!isPicture) return;
  p_.clock.forgetPictures();
  if (hasSwapped_ && ++picturesSinceSwap_ <= kPartsOfFrames) return;
  p_.surfaces.objects.shown(p_.settings.frame());
  ++statistics.framesInMemory;
  ++p_.clock.frame;
  begun_ = false, drawsBefore_ = draws();
  p_.settings.endFrame();
  sourceFrame_ = p_.settings.sourceFrame();
}

void FrameEnds::beforeClear(GLbitfield mask) noexcept {
  endWithOthers(mask);
  p_.failsafe.protect([&] { endInMemory(mask); });
  const bool begins = !std::exchange(begun_, true);
  if ((mask & GL_COLOR_BUFFER_BIT) && draws() == drawsBefore_)
    p_.failsafe.protect([&] { firstCleared_ = p_.shadow.target().framebuffer; });
  if (!begins) return;
  p_.settings.beginFrame();
  if (draws() != drawsBefore_) return;
  p_.failsafe.protect([&] { takeSettings(); });
}

void FrameEnds::chooseEngine() {
  if (!p_.lists.compiling() && !p_.immediate.insideBegin()) p_.passthrough.chooseNext();
}

void FrameEnds::forgetOld() {
  clears_ = 0;
  workForgotten_ = p_.counts.work();
  p_.shadow.group.meshes.advance();
  deleteDiscarded();
}

void FrameEnds::deleteDiscarded() {
  const RealGl& real = p_.shadow.real;
  const SharedNames names = p_.shadow.group.takeDiscarded();
  for (const GLuint id : names.lists) real.DeleteLists(id, 1);
  for (const GLuint id : names.programs) real.DeleteProgram(id);
  if (!names.textures.empty())
    real.DeleteTextures(static_cast<GLsizei>(names.textures.size()), names.textures.data());
}

void FrameEnds::clearing(GLbitfield mask) {
  EngineChoice& choice = p_.clock.choice;
  if (!choice.active()) return;
  if ((mask & kWhole) == kWhole && p_.counts.statistics.frames == 0 && clearsViewport(p_.shadow.real)) {
    p_.passthrough.stopMeasuring();
    chooseEngine();
  } else if (mask & GL_DEPTH_BUFFER_BIT) {
    choice.layer();
  }
  p_.passthrough.works();
}

/// Forgets the surfaces whose depth the clear has removed.
void FrameEnds::endDepths() {
  SurfaceHistory& surfaces = p_.surfaces;
  if (!surfaces.passes.remembers() && surfaces.coplanar.empty()) return surfaces.passes.clear();
  const RealGl& real = p_.shadow.real;
  if (!clearsInFull(real, p_.shadow.rare(), GL_DEPTH_BUFFER_BIT)) return;
  const glm::ivec4 box = scissorBox(real);
  const bool objects = p_.shadow.rare().framebufferObjects;
  const DepthClear depth{objects ? drawFramebuffer(real) : 0, {box.x, box.y, box.z, box.w}};
  surfaces.passes.clear(depth);
  surfaces.coplanar.clear(depth);
}

void FrameEnds::cleared(GLbitfield mask) {
  if (mask & GL_DEPTH_BUFFER_BIT) {
    p_.failsafe.protect([&] { endDepths(); });
    p_.failsafe.depthCleared();
  }
  if (!p_.surfaces.views.empty() || !p_.surfaces.objects.empty() ||
      scene::needsSecondaryScene(p_.shadow.settings) || wantsShownViews(p_.shadow.settings))
    endViews(mask);
  p_.cleared.clear(mask);
  if ((mask & kWhole) != kWhole || p_.counts.work() == workForgotten_) return;
  const int patience = p_.counts.statistics.frames > 0 ? 64 : 4;
  if (++clears_ < patience) return;
  forgetOld();
  p_.surfaces.passes.forgetMany();  // in framebuffers whose depth is never cleared
}

void FrameEnds::endViews(GLbitfield mask) {
  const RealGl& real = p_.shadow.real;
  const auto clears = [&](GLbitfield bit) {
    return (mask & bit) && clearsInFull(real, p_.shadow.rare(), bit);
  };
  const bool depth = clears(GL_DEPTH_BUFFER_BIT), color = clears(GL_COLOR_BUFFER_BIT);
  if (!depth && !color) return;
  const GLuint framebuffer = drawFramebuffer(real);
  const glm::ivec4 at = scissorBox(real);
  const scene::Region box{at.x, at.y, at.z, at.w};
  SurfaceHistory& surfaces = p_.surfaces;
  if (color) {
    glm::vec4 to(0);
    real.GetFloatv(GL_COLOR_CLEAR_VALUE, &to[0]);
    surfaces.views.colorCleared({framebuffer, box, to, p_.counts.statistics.drawsRasterised});
    surfaces.objects.colorCleared(framebuffer, box);
  }
  if (depth) surfaces.views.depthCleared(framebuffer, box), surfaces.objects.depthCleared(framebuffer, box);
}

/// The framebuffer keeps its depth: passes over surfaces of this frame may follow.
void FrameEnds::endFrameInPlace() {
  nextFrame();
  p_.surfaces.passes.shown();
  p_.surfaces.coplanar.shown();
}

void FrameEnds::endFrame() {
  p_.passthrough.stopMeasuring();
  const ContextInfo& info = p_.shadow.info;
  if (info.frameEnding) info.frameEnding();
  endFrameInPlace();
  if (info.frameEnded) info.frameEnded();
}

/// glFlush or glFinish of a double-buffered program. If it never swaps, each one that follows draws into the
/// front buffer ends a frame for the reports, but not for anything else.
void FrameEnds::showFront() {
  const ContextInfo& info = p_.shadow.info;
  Statistics& statistics = p_.counts.statistics;
  if (!info.frameEnded || statistics.frames > 0) return;
  if (draws() == drawsInFront_) return;
  const TargetState& target = p_.shadow.target();
  if (target.framebuffer != 0 || !isFront(target.drawBuffer)) return;
  drawsInFront_ = draws();
  if (info.frameEnding) info.frameEnding();
  ++statistics.framesInFront;
  info.frameEnded();
}

/// glFlush or glFinish of a single-buffered program while the batch is empty: the frame may have been read
/// back before, or all of it was rasterised.
void FrameEnds::showDrawn() {
  if (!p_.clock.choice.drawn()) return;
  if (p_.shadow.target().framebuffer != 0)
    return p_.counts.work() != workForgotten_ ? endFrameInPlace() : void();
  endFrame();
}

/// Other APIs may read the images of framebuffer objects, and other threads may show or read the window.
void FrameEnds::finish() {
  const bool threads = usedByThreads();
  if (threads) p_.failsafe.protect([&] { p_.window.settle(); });
  show(true, threads);
}

void FrameEnds::show(bool objects, bool windows) {
  const bool doubleBuffered = p_.shadow.info.doubleBuffered;
  const int sharing = p_.shadow.group.contexts;
  if (p_.resolves.waits() && sharing > 1) p_.failsafe.protect([&] { p_.flusher.settle(); });
  const Batch& batch = p_.pending.batch;
  if (batch.empty()) {
    const GLuint framebuffer = p_.shadow.target().framebuffer;
    const bool isRead = framebuffer == 0 ? windows || !doubleBuffered : objects || sharing > 1;
    if (isRead) p_.failsafe.protect([&] { p_.relighting.finish(framebuffer); });
    return doubleBuffered ? showFront() : showDrawn();
  }
  const bool object = batch.key().framebuffer != 0;
  const bool visible =
      object ? objects || sharing > 1 : windows || !doubleBuffered || isFront(batch.key().drawBuffer);
  if (!visible) return;
  {
    const FlushPurpose showing(p_.clock, &FrameClock::shows);
    const GLuint framebuffer = batch.key().framebuffer;
    p_.flusher.flush();
    p_.failsafe.protect([&] { p_.relighting.finish(framebuffer); });
  }
  if (object) return;
  doubleBuffered ? showFront() : endFrame();
}

}  // namespace gluray::gl
