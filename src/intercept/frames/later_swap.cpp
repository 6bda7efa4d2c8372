#include "intercept/frames/later_swap.h"

#include "base/clock.h"
#include "intercept/capture/capture.h"
#include "intercept/contexts/context_record.h"
#include "intercept/frames/kept_buffer.h"
#include "intercept/session/guarded.h"
#include "intercept/session/session.h"

#include <memory>

namespace gluray::intercept {

using gl::LagRefusal;

namespace {

/// Whether frames of this thread's context may lag.
bool mayLag(XId drawable) {
  const std::shared_ptr<Record>& record = current().record;
  return session().lag != LagMode::off && !neverLags() && record && record->context &&
         gl::t_thread.context == record->context.get() && current().drawables.draw == drawable &&
         current().drawables.read == drawable && record->context->info().doubleBuffered &&
         !session().picture && !capturing() && wantedImage() != control::Wanted::next;
}

LagRefusal lagged(Record& record, _XDisplay* display, XId drawable, RealSwap swap) {
  if (!record.lag) record.lag = std::make_unique<Lag>();
  gl::Context& context = *record.context;
  const double began = context.clock.beganSeconds;
  const bool follow = record.lag->following.complete(began == 0 ? nowSeconds() : began);
  if (session().lag == LagMode::automatic && !follow) return LagRefusal::single;
  if (session().hud) return LagRefusal::state;
  gl::LagWindow window;
  const auto keep = [&record] { keepBuffer(record, GL_BACK, ShownFrame::later); };
  const LagRefusal refusal =
      record.lag->prepare(display, drawable, swap, session().lag, record.window, keep, window);
  return refusal == LagRefusal::none ? context.frames.lag(window) : refusal;
}

}  // namespace

bool swapsLater(_XDisplay* display, XId drawable, RealSwap swap) noexcept {
  if (!mayLag(drawable)) return false;
  LagRefusal refusal = LagRefusal::failure;
  guarded("cannot show a frame later", [&] { refusal = lagged(*current().record, display, drawable, swap); });
  countLag(refusal);
  return refusal == LagRefusal::none;
}

void noteSwap() noexcept {
  const std::shared_ptr<Record>& record = current().record;
  if (record && record->lag) record->lag->following.swapped(nowSeconds());
}

}  // namespace gluray::intercept
