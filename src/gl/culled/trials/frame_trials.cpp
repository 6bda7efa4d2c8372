#include "gl/culled/trials/frame_trials.h"

#include <algorithm>
#include <limits>

namespace gluray::gl {

FrameTrials::Way FrameTrials::nextFrame(bool always, const Load& last) {
  closeAccounts(last);
  measured_ = running_ = over_ = charged_ = false;
  from_ = at_ = spent_ = gained_ = asked_ = unknown_ = forDraws_ = boxed_ = 0;
  allowance_ = std::numeric_limits<double>::infinity();
  always_ = always;
  secondsOfWork_ = plain_.seconds() > 0 && last.work > 0 ? plain_.seconds() / last.work : 0;
  way_ = always ? Way::culled : choose(last);
  return way_;
}

FrameTrials::Way FrameTrials::choose(const Load& last) {
  if (last.draws < kFewDraws || last.vertices < kFewVertices) return Way::plain;
  if (plain_.seconds() > 0) budget_.earn(plain_.seconds(), kSaved * plain_.seconds());
  if (last.vertices > kSame * load_ || load_ > kSame * last.vertices) startAnew(last.vertices);
  const double most = kTrial * plain_.seconds();
  if (phase_ == Phase::holding && --hold_ <= 0) {
    if (better_ == Way::culled)
      measureAgain(true);
    else
      phase_ = Phase::saving;
  }
  if (phase_ == Phase::saving && budget_.left() >= most) measureAgain(settled_);
  switch (phase_) {
    case Phase::measuring: measured_ = true; return Way::plain;
    case Phase::settling:
      if (budget_.left() <= 0) return Way::plain;
      from_ = reached_, allowance_ = std::min(budget_.left(), kSettling * plain_.seconds());
      return Way::settling;
    case Phase::saving: return Way::plain;
    case Phase::trying:
      if (budget_.left() < most) return Way::plain;
      measured_ = true, allowance_ = most;
      return Way::culled;
    case Phase::holding: allowance_ = most; return better_;
  }
  return Way::plain;
}

/// Charges the frame that has ended to the budget.
void FrameTrials::closeAccounts(const Load& last) {
  if (always_ || charged_ || way_ == Way::plain) return;
  budget_.spend(spent_ - gained_);
  if (way_ == Way::settling && phase_ == Phase::settling) {
    sweepAsked_ += asked_, sweepUnknown_ += unknown_, sweepBoxed_ += boxed_;
    if (over_)
      reached_ = at_ + 1;
    else
      endSweep(last);
  }
  if (way_ == Way::culled && phase_ == Phase::holding) endCulledFrame();
}

void FrameTrials::endSweep(const Load& last) {
  const bool known = last.waiting == 0 || sweepUnknown_ <= kUnknown * sweepAsked_;
  const bool some = sweepBoxed_ >= kBoxed * last.vertices;
  sweepAsked_ = sweepUnknown_ = sweepBoxed_ = reached_ = 0;
  if (!known && ++sweeps_ < kSweeps) return;
  sweeps_ = 0, settled_ = some;
  if (some)
    phase_ = Phase::saving;
  else
    conclude(false);
}

/// Notices when culling no longer pays, without measuring.
void FrameTrials::endCulledFrame() {
  weak_ = gained_ - spent_ < kWeak * paid_ ? weak_ + 1 : 0;
  if (over_ || (weak_ >= kWeakFrames && kCulledHold - hold_ >= kHold)) measureAgain(true);
}

void FrameTrials::stop(double seconds) {
  running_ = false;
  const double took = seconds - startedAt_;
  if (phase_ == Phase::measuring) {
    if (!plain_.add(took)) return;
    if (!begun_) begun_ = true, budget_.add(kSaved * plain_.seconds(), kSaved * plain_.seconds());
    phase_ = settled_ ? Phase::trying : Phase::settling, culled_ = Measurement(kTries);
    return;
  }
  if (phase_ != Phase::trying) return;
  const double plain = plain_.seconds();
  const bool isLast = culled_.add(took);
  budget_.spend(std::max(took - plain, spent_ - gained_)), charged_ = true;
  paid_ = gained_ - spent_;
  if (asked_ > 0) drawSeconds_ = forDraws_ / asked_;
  if (unknown_ > kUnknown * asked_ && !resettled_) return resettled_ = true, measureAgain(false);
  // The first slow frame may be due to chance or cold caches.
  if ((over_ || took > kHopeless * plain) && culled_.fails(kFailures)) return conclude(false);
  if (isLast) conclude(culled_.seconds() < kGain * plain);
}

void FrameTrials::looked(double seconds, double now) {
  cost(seconds);
  if (running_ && phase_ == Phase::trying && now - startedAt_ > kGain * plain_.seconds()) over_ = true;
}

void FrameTrials::startAnew(double vertices) {
  load_ = vertices;
  // If culling does not pay, a changing scene must not start a trial at once.
  if (phase_ == Phase::holding && better_ == Way::plain) {
    hold_ = std::min(hold_, kHold), settled_ = false;
    return;
  }
  if (++restarts_ > kRestarts)
    conclude(false);
  else
    measureAgain(false);
}

/// `settled`: boxes are already computed.
void FrameTrials::measureAgain(bool settled) {
  settled_ = settled, weak_ = 0;
  phase_ = Phase::measuring, plain_ = Measurement(settled ? kTries : 1);
  reached_ = sweepAsked_ = sweepUnknown_ = sweepBoxed_ = 0, sweeps_ = 0;
}

void FrameTrials::conclude(bool pays) {
  restarts_ = weak_ = 0, resettled_ = false;
  if (pays) again_.next = 2 * kHold;
  phase_ = Phase::holding, hold_ = pays ? kCulledHold : again_.take();
  better_ = pays ? Way::culled : Way::plain;
}

}  // namespace gluray::gl
