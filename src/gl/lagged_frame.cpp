#include "gl/lagged_frame.h"

#include "base/clock.h"
#include "base/timeline.h"
#include "gl/clears.h"
#include "gl/context.h"
#include "gl/state_queries.h"

#include <GL/glext.h>

#include <array>
#include <utility>

namespace gluray::gl {

LagRefusal Presenter::traceAhead(const RealGl&, const scene::SnapshotPtr&, const AheadTarget&) noexcept {
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

LagRefusal Context::whyNotLag(GLenum buffer) const {
  if (batch_.empty()) return direct_ ? LagRefusal::measured : LagRefusal::nothingToDo;
  const BatchKey& key = batch_.key();
  const bool right = key.drawBuffer == buffer || (buffer == GL_BACK && key.drawBuffer == GL_BACK_LEFT);
  if (key.framebuffer != 0 || !right || key.samples > 1) return LagRefusal::target;
  if (direct_ || measured()) return LagRefusal::measured;
  // Draws by programs keep the names of textures and buffers, which other contexts may change.
  if (activeQueries > 0 || key.layers != BatchKey::Layers::none || layers.pending() || unresolved_.waiting ||
      compiling() || (!batch_.programDraws().empty() && group_->contexts > 1))
    return LagRefusal::state;
  return aside_ || passthrough_ ? LagRefusal::failure : LagRefusal::none;
}

void Context::noteBegin() {
  if (beganSeconds == 0) beganSeconds = nowSeconds();
}

LagRefusal Context::lag(const LagWindow& window) noexcept {
  LagRefusal refusal = LagRefusal::failure;
  protect([&] {
    if (insideBegin()) return;
    immediate.closeRunIfOpen();
    settleShown();
    refusal = whyNotLag(window.overdue.buffer);
    if (refusal != LagRefusal::none) return;
    if (const GLenum pending = real.GetError()) setError(pending);
    LaggedFrame frame{batch_.key(), batch_.pending(), {}, window, {}, 1, {}};
    const glm::ivec2 size = window.overdue.size;
    if (window.show && mayShowDirectly() && contains(cleared_->region, {0, 0, size.x, size.y})) {
      refresh(kTarget);
      frame.cleared = cleared_;
      frame.farthest = farthestHit(frame.key.depthFunc, state.target.depthResolution);
    }
    refusal = presenter_.traceAhead(real, frame.snapshot,
                                    {frame.key.depthFunc, frame.cleared, frame.farthest, window.overdue});
    if (refusal != LagRefusal::none) return;
    lagged_ = std::move(frame);
    batch_.take();
    lagged_->draws = batch_.takeProgramDraws();
    real.Flush();  // what else the frame holds is drawn meanwhile
  });
  return refusal;
}

/// Shows a frame without the back buffer, where that is cleared next and held nothing else.
bool Context::showsDirectly(const LaggedFrame& frame) {
  constexpr GLbitfield kBoth = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT;
  if (!frame.cleared || frame.clears.empty() || (frame.clears.front().mask & kBoth) != kBoth) return false;
  const PresentResult result = presenter_.show(
      real, frame.snapshot, {*frame.cleared, frame.farthest, info_.core, true, frame.window.show});
  latch.restore(real);
  if (result.outcome != PresentResult::traced) return false;
  takeResult(result);
  noteUse(Quirk::softwareShow);
  return true;
}

PresentResult Context::presentLagged(LaggedFrame& frame) {
  const bool encodes = state.rare.framebufferSrgb && isOn(real, GL_FRAMEBUFFER_SRGB);
  if (encodes) real.Disable(GL_FRAMEBUFFER_SRGB);  // as it was when the program drew
  const PresentResult result = presenter_.present(
      real, frame.snapshot,
      {.depthFunc = frame.key.depthFunc, .core = info_.core, .programDraws = std::move(frame.draws)});
  if (encodes) real.Enable(GL_FRAMEBUFFER_SRGB);
  latch.restore(real);
  takeResult(result);
  frame.window.swap();
  return result;
}

void Context::showLagged() {
  if (!lagged_) return;
  noteBegin();
  const timeline::Span span("show lagged", lagged_->snapshot->instances.size());
  LaggedFrame frame = std::move(*lagged_);
  lagged_.reset();
  const double start = kinds() ? nowSeconds() : 0;
  syncCurrent();
  PresentResult result;
  if (!frame.window.stands()) {
    presenter_.dropAhead();
    result.outcome = PresentResult::traced;  // nobody would have seen it
  } else if (!showsDirectly(frame)) {
    result = presentLagged(frame);
  } else {
    result.outcome = PresentResult::traced;
  }
  for (const WindowClear& clear : frame.clears)
    if (const GLenum pending = presenter_.clear(real, clear)) setError(pending);
  if (kinds()) [[unlikely]]
    kinds()->exclude(nowSeconds() - start);
  if (result.outcome != PresentResult::traced)
    stepAside(result.why.empty() ? "the ray tracer could not make a picture" : result.why.c_str());
}

bool Context::clearsLater(GLbitfield mask) {
  constexpr GLbitfield kKnown = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT;
  constexpr size_t kMostClears = 8;
  noteBegin();
  if (!lagged_ || !batch_.empty() || mask == 0 || mask & ~kKnown || direct_ || aside_ ||
      choice_.wantsStart() || activeQueries > 0 || lagged_->clears.size() >= kMostClears)
    return false;
  if (!clearsWindow(real, state.rare, mask)) return false;
  lagged_->clears.push_back(windowClear(real, mask));
  return true;
}

}  // namespace gluray::gl
