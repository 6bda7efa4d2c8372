#include "intercept/frames/frames.h"

#include "base/clock.h"
#include "base/log.h"
#include "base/never_destroyed.h"
#include "base/timeline.h"
#include "intercept/capture/capture.h"
#include "intercept/contexts/context_record.h"
#include "intercept/contexts/frame_count.h"
#include "intercept/control/link.h"
#include "intercept/frames/kept_buffer.h"
#include "intercept/frames/later_swap.h"
#include "intercept/reports/explanation.h"
#include "intercept/reports/report.h"
#include "intercept/session/guarded.h"
#include "intercept/session/session.h"

namespace gluray::intercept {
namespace {

void endFrame() noexcept {
  captureShown();
  countFrame();
  writeReportIfDue();
}

/// Keeps the image of the frame that is about to be shown, read from the window's `buffer`.
void takeImage(Record& record, GLenum buffer) {
  if (!record.image || !record.context) return;
  glm::ivec2 size = current().size ? current().size() : glm::ivec2(0);
  if (size.x <= 0 || size.y <= 0) {
    GLint viewport[4] = {};
    record.context->real.GetIntegerv(GL_VIEWPORT, viewport);
    size = {viewport[0] + viewport[2], viewport[1] + viewport[3]};
  }
  if (size.x > 0 && size.y > 0)
    keepImage(record.image->readFrame(record.context->real, buffer, size.x, size.y, framesEnded() + 1));
}

/// Draws the HUD over the frame that is about to be shown, unless the program could notice it.
void drawHud(Record& record) {
  gl::Context& context = *record.context;
  if (context.info().off || context.immediate.insideBegin() || context.shadow.activeQueries > 0) return;
  GLint mode = GL_RENDER;
  if (!context.info().core) context.real.GetIntegerv(GL_RENDER_MODE, &mode);
  if (mode != GL_RENDER) return;
  if (!record.hud) record.hud = std::make_unique<Hud>(context.real);
  const GLenum pending = record.hud->draw(totals().statistics, nowSeconds());
  if (pending != GL_NO_ERROR) context.errors.set(pending);
}

/// Makes new contexts record what the report needs.
class Watcher final : public ContextWatcher {
 public:
  void making(Record& record, gl::ContextInfo& info) override {
    if (!session().reportFile.empty() || capturing()) info.frameEnded = endFrame;
    if (capturing())
      info.pictureRead = [&record](const scene::Region& region) { captureRead(record, region); };
    const bool images = session().explainFrames && session().picture;
    const bool es = record.version.starts_with("OpenGL ES");
    if (!es && (images || mayBeControlled() || capturing()))
      info.frameEnding = [&record] {
        captureShowing(record, GL_FRONT);
        takeImage(record, GL_FRONT);
        keepBuffer(record, GL_FRONT, ShownFrame::now);
      };
    if (log::enabled(log::Level::trace)) info.decisions = std::make_shared<gl::Decisions>();
    if (!session().explainFrames && !info.decisions) return;
    info.kinds = std::make_shared<gl::DrawKinds>(!info.core);
    if (!es && images) record.image = std::make_unique<present::FrameImage>();
  }
  void made() noexcept override { watchForReport(); }
};

}  // namespace

void followContexts() noexcept {
  static NeverDestroyed<Watcher> watcher;  // programs create contexts while they exit
  watchContexts(*watcher);
}

void swapping(uintptr_t drawable) noexcept {
  flushCurrent();
  guarded("cannot measure a frame", [&] {
    if (gl::t_thread.context && current().drawables.draw == drawable)
      gl::t_thread.context->passthrough.stopMeasuring();
  });
  const bool wanted = wantedImage() != control::Wanted::none;
  if (!session().picture && !session().hud && !wanted && !capturing()) return;
  if (!current().record || current().drawables.draw != drawable || !current().record->context ||
      !current().record->context->info().doubleBuffered)
    return;
  captureShowing(*current().record, GL_BACK);
  guarded("cannot take an image", [&] {
    if (session().picture) takeImage(*current().record, GL_BACK);
  });
  guarded("cannot show figures", [&] {
    if (session().hud) drawHud(*current().record);
  });
  if (wanted) keepBuffer(*current().record, GL_BACK, ShownFrame::now);
}

void swapped(uintptr_t drawable) noexcept {
  guarded("cannot end a frame", [&] {
    gl::Context* context = gl::t_thread.context;
    // Without a back buffer a swap shows nothing new: glFlush and glFinish end frames there.
    if (context && current().drawables.draw == drawable && context->info().doubleBuffered)
      context->frames.afterSwap(), captureShown(), countFrame(), timeline::mark("frame");
  });
  noteSwap();
  writeReportIfDue();
}

}  // namespace gluray::intercept
