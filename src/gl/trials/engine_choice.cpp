#include "gl/trials/engine_choice.h"

#include <cmath>
#include <utility>

namespace gluray::gl {
namespace {

constexpr int kSettle = 4;      // frames before measuring: lists are compiled, shaders built
constexpr int kTimes = 3;       // frames measured; the fastest counts: noise only adds time
constexpr int kAttempts = 32;   // frames of another load after which measuring stops
constexpr int kWindow = 32;     // frames over which the largest load is taken
constexpr double kStays = 2.0;  // maximum ratio of loads until a kind is left
constexpr size_t kKinds = 32;
constexpr double kTrusted = 60;  // seconds until a way that a precedent has chosen is compared with the other
constexpr double kMet = 2;       // maximum ratio of a measured time and that of a precedent which is trusted

}  // namespace

EngineChoice::EngineChoice(const Between& engines, Clock clock)
    : active_(engines.setting == Engine::automatic),
      threads_(std::max(engines.threads, 1)),
      software_(engines.software),
      precedents_(engines.precedents ? engines.precedents : std::make_shared<Precedents>()),
      clock_(clock),
      way_(engines.setting == Engine::never    ? Way::passthrough
           : engines.setting == Engine::always ? Way::traced
                                               : Way::mixed) {}

double EngineChoice::mostTriangles(double pixels) {
  constexpr double kAlways = 20000;  // drawn in a millisecond or two
  constexpr double kMax = 200000;    // their list compiles in some 30 ms
  constexpr double kPerPixel =
      0.2;  // for more triangles a rasteriser on the same cores is slower than tracing
  return std::clamp(kPerPixel * pixels, kAlways, kMax);
}

bool EngineChoice::takesAlone(uint64_t triangles, double viewportPixels) const {
  if (!active_) return way_ == Way::passthrough;
  if (!software_) return true;
  const double pixels = frame_.pixels + std::max(epochPixels_, viewportPixels);
  const double measured = way_ == Way::passthrough ? mostDirect_ : 0;
  return static_cast<double>(triangles) <= std::max(mostTriangles(pixels), measured);
}

bool EngineChoice::takes(uint64_t triangles, double viewportPixels) const {
  // After an overflow each draw is judged alone, so that a surface that is drawn again is drawn in the same
  // way.
  const bool inAll = active_ && way_ == Way::mixed && !overflowed_;
  return takesAlone(triangles + (inAll ? static_cast<uint64_t>(frame_.triangles) : 0), viewportPixels);
}

bool EngineChoice::takesLayers(uint64_t triangles, double viewportPixels) const {
  // Every further hit of a ray costs about as much as the first. Three closed surfaces of a million
  // triangles, on as many pixels, take tracing and a rasteriser on the same cores equally long.
  constexpr double kAlways = 200000, kPerPixel = 1;
  return active_ &&
         (!software_ || static_cast<double>(triangles) <= std::max(kAlways, kPerPixel * viewportPixels));
}

void EngineChoice::overflow() {
  overflowed_ = true;
  way_ = Way::mixed;
  trial_ = false;
}

EngineChoice::Way EngineChoice::frameEnded() {
  layer();
  const FrameLoad load = std::exchange(frame_, {});
  const bool drawn = std::exchange(drawn_, false);
  const double seconds = std::exchange(frameSeconds_, -1);
  const bool measuring = phase_ == Phase::measuring || trial_;
  timing_ = active_ && measuring ? Timing::wanted : Timing::off;
  if (!active_ || !drawn) return way_;

  remember(load);
  const FrameLoad peak = largest(peaks_[0], peaks_[1]);
  const bool known = load.triangles <= mostDirect_;
  if (way_ == Way::mixed || (way_ == Way::passthrough && tooLarge(load, 1.5) && !known)) {
    Kind& kind = kindOf(peak);
    kind_ = static_cast<size_t>(&kind - kinds_.data());
    settle(fasterByPrecedent(kind, tooLarge(load, 1) ? Way::traced : Way::passthrough), false);
    overflowed_ = false;
    return way_;
  }
  if (!within(peak, kinds_[kind_].load, kStays)) {
    if (trial_) account(kinds_[kind_], seconds);
    enter(kindOf(peak));
    return way_;
  }
  account(kinds_[kind_], seconds);
  switch (phase_) {
    case Phase::settling:
      if (--settles_ > 0) {
        if (!affordsAnother(kinds_[kind_], seconds)) giveUp(seconds);
        break;
      }
      if (isHopeless(kinds_[kind_], seconds) || !affordsAnother(kinds_[kind_], seconds))
        measured_ = Measurement(1), measured_.add(seconds), conclude();
      else
        measure(trial_ ? 1 : kTimes);
      break;
    case Phase::measuring: {
      const bool counts = seconds >= 0 && within(load, kinds_[kind_].load, kStays);
      const bool complete = counts ? measured_.add(seconds) : measured_.fails(kAttempts);
      if (complete || !affordsAnother(kinds_[kind_], seconds)) conclude();
      break;
    }
    case Phase::holding:
      if (clock_() >= nextLook_) measure(kTimes);
      break;
  }
  return way_;
}

/// Ends a trial with its first frame, which says what the next trial may cost but not what frames take:
/// structures and shaders are built in it.
void EngineChoice::giveUp(double seconds) {
  kinds_[kind_].tried[indexOf(way_)] = seconds;
  endTrial(false);
  hold(clock_() + lookInterval_.take());
}

/// `faster`: the way that was tried is kept.
void EngineChoice::endTrial(bool faster) {
  Kind& kind = kinds_[kind_];
  kind.nextTrial = clock_() + kind.trialInterval.take();
  if (!faster) way_ = other(way_);
  permitDirect();
}

void EngineChoice::remember(const FrameLoad& load) {
  if (++window_ >= kWindow) {
    window_ = 0;
    peaks_[1] = std::exchange(peaks_[0], {});
  }
  peaks_[0] = largest(peaks_[0], load);
}

EngineChoice::Kind& EngineChoice::kindOf(const FrameLoad& load) {
  for (Kind& kind : kinds_)
    if (within(kind.load, load, kSame)) return kind;
  if (kinds_.size() >= kKinds) kinds_.clear();
  Kind& kind = kinds_.emplace_back(Kind{load});
  kind.precedent = precedents_->find(load);
  if (kind.precedent) kind.nextTrial = clock_() + kTrusted;
  return kind;
}

EngineChoice::Way EngineChoice::fasterByPrecedent(const Kind& kind, Way otherwise) {
  if (!kind.precedent) return otherwise;
  const double traced = kind.precedent->traced, direct = kind.precedent->direct;
  return traced < kFaster * direct ? Way::traced : direct < kFaster * traced ? Way::passthrough : otherwise;
}

/// Compares the times of frames with those of the kind's precedent, which a trial replaces as soon as one is
/// affordable if they differ: the load of the machine, the program or the light is another one.
void EngineChoice::compareWithPrecedent(Kind& kind) {
  const double here = kind.seconds[indexOf(way_)];
  if (!kind.precedent || here < 0) return;
  const double then = way_ == Way::traced ? kind.precedent->traced : kind.precedent->direct;
  if (here <= kMet * then && then <= kMet * here) return;
  kind.precedent.reset();
  kind.nextTrial = 0;
}

/// Changes to another kind of frames.
void EngineChoice::enter(Kind& kind) {
  kind_ = static_cast<size_t>(&kind - kinds_.data());
  lookInterval_.restart();
  // An interrupted trial has no result: its way does not count as used.
  const Way used = trial_ ? other(way_) : way_, unused = other(used);
  const double here = kind.seconds[indexOf(used)], there = kind.seconds[indexOf(unused)];
  const bool mustLeave = used == Way::passthrough && tooLarge(kind.load, 1) && here < 0;
  if (here >= 0 && there >= 0) return settle(there < kFaster * here ? unused : used, false);
  settle(fasterByPrecedent(kind, mustLeave ? unused : used), false);
}

void EngineChoice::settle(Way way, bool trial) {
  way_ = way;
  trial_ = trial;
  phase_ = Phase::settling;
  settles_ = trial ? kTrialSettle : kSettle;
  timing_ = trial ? Timing::wanted : Timing::off;
  permitDirect();
}

/// Permits passthrough frames of this kind to have more triangles than an OpenGL on the CPU draws unmeasured.
void EngineChoice::permitDirect() {
  const Kind& kind = kinds_[kind_];
  const bool any = trial_ || kind.seconds[indexOf(Way::passthrough)] >= 0 ||
                   fasterByPrecedent(kind, Way::traced) == Way::passthrough;
  mostDirect_ = any ? kStays * kind.load.triangles : 0;
}

void EngineChoice::measure(int frames) {
  phase_ = Phase::measuring;
  measured_ = Measurement(frames);
  timing_ = Timing::wanted;
}

/// Holds the decision until frames are of another kind, or until `nextLook`.
void EngineChoice::hold(double nextLook) {
  phase_ = Phase::holding;
  trial_ = false;
  timing_ = Timing::off;
  nextLook_ = nextLook;
}

/// Makes the result of a trial a precedent.
void EngineChoice::keep(Kind& kind) {
  kind.precedent.reset();
  precedents_->add({kind.load, kind.seconds[indexOf(Way::traced)], kind.seconds[indexOf(Way::passthrough)]});
}

void EngineChoice::conclude() {
  Kind& kind = kinds_[kind_];
  const Way unused = other(way_);
  if (measured_.isKnown()) kind.seconds[indexOf(way_)] = measured_.seconds();
  compareWithPrecedent(kind);
  const double here = kind.seconds[indexOf(way_)], there = kind.seconds[indexOf(unused)];
  if (trial_) {
    if (measured_.isKnown()) keep(kind);
    endTrial(measured_.isKnown() && here <= kFaster * there);
  } else {
    if (measured_.isKnown() && clock_() >= kind.nextTrial && mayTry(unused, kind, here))
      return settle(unused, true);
  }
  hold(clock_() + lookInterval_.take());
}

}  // namespace gluray::gl
