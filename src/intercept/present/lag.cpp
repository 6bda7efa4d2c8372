// Frame lag: pictures that are traced while the program goes on.
#include "gl/lagged_frame.h"
#include "intercept/present/late_picture.h"
#include "intercept/present/tracing_presenter.h"

#include <exception>
#include <functional>
#include <memory>
#include <utility>

namespace gluray::present {

using gl::LagRefusal;

namespace {

/// Shows the picture with what is under it in the window.
std::function<void(const Image&)> showOver(std::shared_ptr<WindowContent> under,
                                           const gl::AheadTarget& target) {
  return [under = std::move(under), depthFunc = target.depthFunc,
          show = target.overdue.show](const Image& image) {
    if (merge(image, depthFunc, *under)) show(under->colors.data());
  };
}

/// The same where that is one colour.
std::function<void(const Image&)> showOver(uint32_t background, const gl::AheadTarget& target) {
  return [background, farthest = target.farthest, size = target.overdue.size,
          show = target.overdue.show](const Image& image) {
    try {
      WindowContent content = plainWindow(size, background, farthest);
      if (merge(image, GL_LEQUAL, content)) show(content.colors.data());
    } catch (const std::exception&) {}  // without memory it is shown when the program goes on
  };
}

}  // namespace

LagRefusal TracingPresenter::traceAhead(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                        const gl::AheadTarget& target) noexcept {
  try {
    std::string why;
    if (!supports(real, false, why)) return LagRefusal::failure;
    std::optional<uint32_t> background;
    PendingErrors none;  // the caller has asked
    if (target.cleared) background = clearedWindow_.bits(real, features(real), *target.cleared, none);
    if (pictures_.of(*snapshot, background)) return LagRefusal::repeated;
    if (!ahead_) ahead_ = std::make_unique<TraceAhead>(tracer_.trace);
    TraceAhead::Late late;
    late.due = TraceAhead::Clock::now() + target.overdue.after;
    if (target.overdue.show && background) {
      late.show = showOver(*background, target);
    } else if (target.overdue.show) {
      auto under = std::make_shared<WindowContent>();
      if (!readWindow(real, features(real), target.overdue.size, target.overdue.buffer, *under))
        return LagRefusal::window;
      late.show = showOver(std::move(under), target);
    }
    return ahead_->start(snapshot, background.value_or(0), std::move(late)) ? LagRefusal::none
                                                                            : LagRefusal::failure;
  } catch (const std::exception&) { return LagRefusal::failure; }
}

void TracingPresenter::dropAhead() noexcept {
  if (ahead_) ahead_->drop();
}

GLenum TracingPresenter::clear(const gl::RealGl& real, const gl::WindowClear& clear) noexcept {
  try {
    const PendingErrors pending = takeErrors(real);
    clearWindow(real, features(real), clear);
    takeErrors(real);
    return pending.empty() ? GLenum{GL_NO_ERROR} : pending.front();
  } catch (const std::exception&) {
    real.Clear(clear.mask);  // without memory for the guard: with the state of now
    return GL_NO_ERROR;
  }
}

}  // namespace gluray::present
