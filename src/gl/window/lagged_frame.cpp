#include "gl/window/lagged_frame.h"

#include "base/clock.h"
#include "base/timeline.h"
#include "gl/context.h"
#include "gl/state/state_queries.h"
#include "gl/window/clears.h"
#include "gl/window/window_frames.h"

#include <GL/glext.h>

#include <array>
#include <utility>

namespace gluray::gl {

LagRefusal WindowPresenter::traceAhead(const RealGl&, const scene::SnapshotPtr&,
                                       const AheadTarget&) noexcept {
  return LagRefusal::failure;
}

std::string_view describe(LagRefusal refusal) {
  constexpr std::array<std::string_view, kLagRefusals> kWords = {
      "shown later",
      "nothing waited to be traced at the swap",
      "what waited was not for a plain back buffer",
      "nothing had changed",
      "the real OpenGL drew it, or it was measured",
      "a query, layers or other contexts",
      "frames did not follow each other",
      "the window's content cannot be shown without the program",
      "no thread or no memory"};
  return kWords.at(static_cast<size_t>(refusal));
}

LagRefusal WindowFrames::whyNotLag(GLenum buffer) const {
  if (c_.batch().empty()) return c_.direct() ? LagRefusal::measured : LagRefusal::nothingToDo;
  const BatchKey& key = c_.batch().key();
  const bool right = key.drawBuffer == buffer || (buffer == GL_BACK && key.drawBuffer == GL_BACK_LEFT);
  if (key.framebuffer != 0 || !right || key.samples > 1 || !key.colorWrites.all() || key.encodes)
    return LagRefusal::target;
  if (c_.direct() || c_.measured()) return LagRefusal::measured;
  // Draws by programs keep the names of textures and buffers, which other contexts may change.
  if (c_.activeQueries > 0 || key.layers != BatchKey::Layers::none || c_.layers.pending() ||
      c_.resolves.waits() || c_.compiling() ||
      (!c_.batch().programDraws().empty() && c_.group().contexts > 1))
    return LagRefusal::state;
  return c_.aside() || c_.passthrough() ? LagRefusal::failure : LagRefusal::none;
}

void WindowFrames::noteBegin() {
  if (c_.beganSeconds == 0) c_.beganSeconds = nowSeconds();
}

LagRefusal WindowFrames::lag(const LagWindow& window) noexcept {
  LagRefusal refusal = LagRefusal::failure;
  c_.protect([&] {
    if (c_.insideBegin()) return;
    c_.immediate.closeRunIfOpen();
    settle();
    refusal = whyNotLag(window.overdue.buffer);
    if (refusal != LagRefusal::none) return;
    if (const GLenum pending = c_.real.GetError()) c_.setError(pending);
    LaggedFrame frame{c_.batch().key(), c_.batch().pending(), {}, window, {}, 1, {}};
    const glm::ivec2 size = window.overdue.size;
    if (window.show && mayShowDirectly() && contains(c_.clearedTarget()->region, {0, 0, size.x, size.y})) {
      c_.refresh(kTarget);
      frame.cleared = c_.clearedTarget();
      frame.farthest = farthestHit(frame.key.depthFunc, c_.state.target.depthResolution);
    }
    refusal = c_.presenter().window().traceAhead(
        c_.real, frame.snapshot, {frame.key.depthFunc, frame.cleared, frame.farthest, window.overdue});
    if (refusal != LagRefusal::none) return;
    lagged_ = std::move(frame);
    c_.batch().take();
    lagged_->draws = c_.batch().takeProgramDraws();
    c_.real.Flush();  // what else the frame holds is drawn meanwhile
  });
  return refusal;
}

/// Shows a frame without the back buffer, where that is cleared next and held nothing else.
bool WindowFrames::showsDirectly(const LaggedFrame& frame) {
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if (!frame.cleared || frame.clears.empty() || (frame.clears.front().mask & kBoth) != kBoth) return false;
  const PresentResult result = c_.presenter().window().show(
      c_.real, frame.snapshot, {*frame.cleared, frame.farthest, c_.info().core, true, frame.window.show});
  c_.latch.restore(c_.real);
  if (result.outcome != PresentResult::traced) return false;
  c_.takeResult(result);
  noteUse(Quirk::softwareShow);
  return true;
}

PresentResult WindowFrames::presentLagged(LaggedFrame& frame) {
  const PresentResult result = c_.presenter().present(
      c_.real, frame.snapshot,
      {.depthFunc = frame.key.depthFunc, .core = c_.info().core, .programDraws = std::move(frame.draws)});
  c_.latch.restore(c_.real);
  c_.takeResult(result);
  frame.window.swap();
  return result;
}

void WindowFrames::showLagged() {
  if (!lagged_) return;
  noteBegin();
  const timeline::Span span("show lagged", lagged_->snapshot->instances.size());
  LaggedFrame frame = std::move(*lagged_);
  lagged_.reset();
  const double start = c_.kinds() ? nowSeconds() : 0;
  c_.syncCurrent();
  PresentResult result;
  if (!frame.window.stands()) {
    c_.presenter().window().dropAhead();
    result.outcome = PresentResult::traced;  // nobody would have seen it
  } else if (!showsDirectly(frame)) {
    result = presentLagged(frame);
  } else {
    result.outcome = PresentResult::traced;
  }
  for (const WindowClear& clear : frame.clears)
    if (const GLenum pending = c_.presenter().window().clear(c_.real, clear)) c_.setError(pending);
  if (c_.kinds()) [[unlikely]]
    c_.kinds()->exclude(nowSeconds() - start);
  if (result.outcome != PresentResult::traced)
    c_.stepAside(result.why.empty() ? "the ray tracer could not make a picture" : result.why.c_str());
}

bool WindowFrames::clearsLater(GLbitfield mask) {
  constexpr GLbitfield kKnown = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  constexpr size_t kMostClears = 8;
  noteBegin();
  if (!lagged_ || !c_.batch().empty() || mask == 0 || mask & ~kKnown || c_.direct() || c_.aside() ||
      c_.startsMeasuring() || c_.activeQueries > 0 || lagged_->clears.size() >= kMostClears)
    return false;
  if (!clearsWindow(c_.real, c_.state.rare, mask)) return false;
  lagged_->clears.push_back(windowClear(c_.real, mask));
  return true;
}

}  // namespace gluray::gl
