#include "control/link/program/waker.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace gluray::control {

bool Waker::drew() { return program_.figures().scene != draws_; }

void Waker::begin(double now) {
  wanted_ = false;
  frame_ = source_.begun().frame;
  draws_ = program_.figures().scene;
  if (onlyShows_) return tellWider(now);
  program_.wake();
  go(Step::exposed, now + kLook);
}

void Waker::tellWider(double now) {
  draws_ = program_.figures().scene;
  program_.tellSize(true);
  go(Step::wider, now + kWider);
}

/// If the program has begun and shown a frame since, but has drawn nothing of its scene, it has shown a
/// cached image.
void Waker::seeExposure(double now) {
  if (drew()) return go(Step::rest, 0);
  if (std::exchange(wanted_, false)) program_.wake();
  if (now < due_) return;
  const bool showed = source_.frame() >= frame_ + 2 && draws_ > 0;
  if (showed && failures_ < kMaxFailures) return tellWider(now);
  go(Step::rest, 0);
}

void Waker::passed(double now) {
  if (step_ == Step::exposed) seeExposure(now);
  if (step_ == Step::wider && now >= due_) {
    program_.tellSize(false);
    calm_ = now + kCalm;
    go(Step::told, now + kLook);
  }
  if (step_ == Step::told && (drew() || now >= due_)) {
    onlyShows_ = drew();
    failures_ = onlyShows_ ? 0 : failures_ + 1;
    go(Step::rest, 0);
  }
  if (step_ == Step::rest && wanted_) begin(now);
}

double Waker::nextDue(double now) const {
  if (step_ == Step::rest) return wanted_ ? now : std::numeric_limits<double>::infinity();
  return step_ == Step::wider ? due_ : std::min(due_, now + kPoll);
}

}  // namespace gluray::control
