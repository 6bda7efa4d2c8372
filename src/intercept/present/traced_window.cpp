#include "intercept/present/traced_window.h"

#include "base/clock.h"
#include "frame/pixels/window_content.h"
#include "gl/window/lagged_frame.h"
#include "intercept/present/read_back/window_buffers.h"
#include "intercept/present/result_of.h"

#include <exception>
#include <functional>
#include <memory>
#include <utility>

namespace gluray::present {

using gl::LagRefusal, gl::PresentResult;

namespace {

/// Callback that shows the image merged with the window's content.
std::function<void(const Image&)> showOver(std::shared_ptr<frame::WindowContent> under,
                                           const gl::AheadTarget& target) {
  const auto test = target.depthFunc == GL_LESS ? frame::DepthTest::less : frame::DepthTest::lessOrEqual;
  return [under = std::move(under), test, show = target.overdue.show](const Image& image) {
    if (merge(image, test, *under)) show(under->colors.data());
  };
}

/// The same for a window of one colour.
std::function<void(const Image&)> showOver(uint32_t background, const gl::AheadTarget& target) {
  return [background, farthest = target.farthest, size = target.overdue.size,
          show = target.overdue.show](const Image& image) {
    try {
      frame::WindowContent content = frame::plainWindow(size, background, farthest);
      if (merge(image, frame::DepthTest::lessOrEqual, content)) show(content.colors.data());
    } catch (const std::exception&) {}  // out of memory: it is shown when the program goes on
  };
}

}  // namespace

LagRefusal TracedWindow::traceAhead(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                    const gl::AheadTarget& target) noexcept {
  try {
    std::string why;
    if (!shared_.supported(real, why)) return LagRefusal::failure;
    std::optional<uint32_t> background;
    PendingErrors none;  // the caller has taken errors
    if (target.cleared)
      background = shared_.clearedWindow.bits(real, shared_.features(real), *target.cleared, none);
    if (shared_.images.knows(*snapshot, background)) return LagRefusal::repeated;
    frame::TraceAhead::Late late;
    late.due = frame::TraceAhead::Clock::now() + target.overdue.after;
    if (target.overdue.show && background) {
      late.show = showOver(*background, target);
    } else if (target.overdue.show) {
      auto under = std::make_shared<frame::WindowContent>();
      if (!readWindow(real, shared_.features(real), target.overdue.size, target.overdue.buffer, *under))
        return LagRefusal::window;
      late.show = showOver(std::move(under), target);
    }
    return shared_.images.startAhead(snapshot, background.value_or(0), std::move(late)) ? LagRefusal::none
                                                                                        : LagRefusal::failure;
  } catch (const std::exception&) { return LagRefusal::failure; }
}

void TracedWindow::refineWhileIdle(const gl::OpenIdleWindow& open) noexcept {
  shared_.images.frame().refineWhileIdle(open);
}

void TracedWindow::stopRefining() noexcept { shared_.images.frame().stop(); }

void TracedWindow::dropAhead() noexcept { shared_.images.dropAhead(); }

bool TracedWindow::knowsClear(const gl::ClearedTarget& cleared) const noexcept {
  return shared_.clearedWindow.knows(cleared);
}

GLenum TracedWindow::clear(const gl::RealGl& real, const gl::WindowClear& clear) noexcept {
  try {
    const PendingErrors pending = takeErrors(real);
    clearWindow(real, shared_.features(real), clear);
    takeErrors(real);
    return pending.empty() ? GLenum{GL_NO_ERROR} : pending.front();
  } catch (const std::exception&) {
    real.Clear(clear.mask);  // out of memory for the guard: clear with the current state
    return GL_NO_ERROR;
  }
}

PresentResult TracedWindow::show(const gl::RealGl& real, const scene::SnapshotPtr& snapshot,
                                 const gl::ShowTarget& target) noexcept {
  return resultOf([&] {
    PresentResult result;
    PendingErrors pending;
    const std::optional<uint32_t> background =
        shared_.clearedWindow.bits(real, shared_.features(real), target.cleared, pending);
    if (!pending.empty()) result.pendingError = pending.front();
    if (!background) return result;
    const frame::ImageCache::CachedImage* traced =
        shared_.imageOf(*snapshot, target.wish, background, result, result.why);
    if (!traced || traced->image.planes != Image::kColorDepth || traced->image.missColor != *background)
      return result;
    const double start = nowSeconds();
    if (target.show({traced->image, target.farthest, traced->id, snapshot->settings.threads}))
      result.outcome = PresentResult::traced, shared_.images.frame().wrote(snapshot, *traced, traced->image);
    result.presentSeconds = nowSeconds() - start;
    return result;
  });
}

}  // namespace gluray::present
