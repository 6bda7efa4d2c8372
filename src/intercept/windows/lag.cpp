#include "intercept/windows/lag.h"

#include "base/clock.h"
#include "base/timeline.h"
#include "intercept/context_record.h"
#include "intercept/control/window_pictures.h"
#include "intercept/session.h"
#include "intercept/window_systems/drawable_size.h"
#include "intercept/windows/background_window.h"
#include "intercept/windows/closed_displays.h"
#include "intercept/windows/following_frames.h"

#include <GL/glx.h>

#include <atomic>
#include <chrono>

namespace gluray::intercept {

using gl::LagRefusal;

namespace {

using namespace std::chrono_literals;
constexpr auto kOverdue = 25ms;  // time after a swap without a call of the program until we show the frame

std::atomic<bool> g_never{false};
std::atomic<uint64_t> g_later{0}, g_shownByUs{0};
std::array<std::atomic<uint64_t>, gl::kLagRefusals> g_because{};

}  // namespace

class Lag {
 public:
  FollowingFrames following;

  /// Prepares showing a frame of `drawable` later; returns the reason if that is impossible.
  LagRefusal prepare(Display* display, GLXDrawable drawable, RealSwap swap, Record& record,
                     gl::LagWindow& window) {
    if (display != display_ || drawable != drawable_) adopt(display, drawable);
    const bool automatic = session().lag == LagMode::automatic;
    if (!closed_ || (automatic && !background_)) return LagRefusal::window;
    const glm::ivec2 size = drawableSize(display, drawable);
    if (size.x <= 0) return LagRefusal::window;
    const auto closed = closed_;
    window.stands = [=] { return !*closed && drawableSize(display, drawable).x > 0; };
    window.swap = [=, &record] {
      const Outermost nested;
      keepBuffer(record, GL_BACK, ShownFrame::later);
      const timeline::Span span("swap");
      windowChanges(drawable);
      swap(display, drawable);
      record.window.swapped = {0, 0};  // of a size that the next command sees
    };
    window.overdue.size = size;
    window.show = [=, &to = record.window](const gl::ShownPicture& picture) {
      ShmWindow* const put = shmWindowFor(display, drawable, to);
      if (!put) return false;
      const glm::ivec2 now = put->size();
      if (!to.isKnown(now) || !put->put(picture, now)) return false;
      keepShownPicture(picture, now, ShownFrame::later);
      return true;
    };
    if (!background_) return LagRefusal::none;
    window.overdue.after = kOverdue;
    window.overdue.show = [background = background_, size](const uint32_t* pixels) {
      if (!background->paint(pixels, size)) return;
      ++g_shownByUs;
      keepPixels(pixels, size);
    };
    return LagRefusal::none;
  }

 private:
  void adopt(Display* display, GLXDrawable drawable) {
    display_ = display, drawable_ = drawable;
    closed_ = watchDisplay(display);
    background_ = BackgroundWindow::open(DisplayString(display), static_cast<uint32_t>(windowOf(drawable)));
  }

  Display* display_ = nullptr;
  GLXDrawable drawable_ = 0;
  Closed closed_;
  std::shared_ptr<BackgroundWindow> background_;
};

void LagDeleter::operator()(Lag* lag) const { delete lag; }

namespace {

/// Whether frames of this thread's context may lag at all.
bool mayLag(GLXDrawable drawable) {
  const std::shared_ptr<Record>& record = current().record;
  return session().lag != LagMode::off && !g_never && record && record->context &&
         gl::t_thread.context == record->context.get() && current().drawables.draw == drawable &&
         current().drawables.read == drawable && record->context->info().doubleBuffered &&
         !session().picture && wantedPicture() != control::Wanted::next;
}

LagRefusal lagged(Record& record, Display* display, GLXDrawable drawable, RealSwap swap) {
  if (!record.lag) record.lag.reset(new Lag);
  gl::Context& context = *record.context;
  const double began = context.clock.beganSeconds;
  const bool follow = record.lag->following.complete(began == 0 ? nowSeconds() : began);
  if (session().lag == LagMode::automatic && !follow) return LagRefusal::single;
  if (session().hud) return LagRefusal::state;
  gl::LagWindow window;
  const LagRefusal refusal = record.lag->prepare(display, drawable, swap, record, window);
  return refusal == LagRefusal::none ? context.frames.lag(window) : refusal;
}

}  // namespace

bool swapsLater(Display* display, GLXDrawable drawable, RealSwap swap) noexcept {
  if (!mayLag(drawable)) return false;
  LagRefusal refusal = LagRefusal::failure;
  guarded("cannot show a frame later", [&] { refusal = lagged(*current().record, display, drawable, swap); });
  ++g_because.at(static_cast<size_t>(refusal));
  if (refusal != LagRefusal::none) return false;
  ++g_later;
  return true;
}

void noteSwap() noexcept {
  const std::shared_ptr<Record>& record = current().record;
  if (record && record->lag) record->lag->following.swapped(nowSeconds());
}

void neverLag() noexcept { g_never = true; }

LagCounts lagCounts() noexcept {
  LagCounts counts{g_later, g_shownByUs, {}};
  for (size_t i = 1; i < g_because.size(); ++i) counts.because.at(i) = g_because.at(i);
  return counts;
}

}  // namespace gluray::intercept
