// EngineChoice: what frames and trials cost, and which trials are affordable.
#include "gl/trials/engine_choice.h"

namespace gluray::gl {
namespace {

constexpr double kOptimism = 0.6;          // lower limit of a cost now, as a share of its measurement
constexpr double kShare = 0.01;            // of the real OpenGL's drawing time, spent on trials of tracing
constexpr double kMaxSavedSeconds = 0.25;  // maximum budget above an OpenGL on the CPU
constexpr double kMaxSavedInHardware = 5;  // above one in hardware, where tracing is the slower guess
constexpr double kBuildTriangle = 0.3e-6;  // seconds for a triangle of the first frame: capture, structures
constexpr double kHopeless = 2;        // a second frame of a trial that is this many times as slow ends it
constexpr double kLikely = 2;          // estimate of a traced frame, in units of leastTraceSeconds()
constexpr double kLikelyDirect = 3;    // of a passthrough frame, in units of leastDirectSeconds()
constexpr double kFirstTrace = 20e-3;  // seconds: the first one starts threads and builds shaders

}  // namespace

/// Adds to the limit for all frames, and to the budget for those that the real OpenGL draws. Charges frames
/// of trials to the limit, and those of tracing to the budget.
void EngineChoice::account(const Kind& kind, double seconds) {
  const double known = kind.seconds[indexOf(trial_ ? other(way_) : way_)];
  if (known >= 0) limit_.drew(known);
  if (trial_ && known >= 0 && seconds >= 0) limit_.spend(seconds - known);
  const double direct = kind.seconds[indexOf(Way::passthrough)];
  everTraced_ |= way_ == Way::traced;
  if (direct < 0) return;
  if (way_ == Way::passthrough)
    budget_.add(kShare * direct, software_ ? kMaxSavedSeconds : kMaxSavedInHardware);
  else if (trial_ && seconds >= 0)
    budget_.spend(seconds - direct);
}

/// Whether a settled frame of a trial shows that its way is much slower.
bool EngineChoice::isHopeless(const Kind& kind, double seconds) const {
  const double known = kind.seconds[indexOf(other(way_))];
  return trial_ && known >= 0 && seconds >= kHopeless * known;
}

/// Whether another frame like the last one, of `seconds`, keeps within the limit of trials. True outside
/// trials.
bool EngineChoice::affordsAnother(const Kind& kind, double seconds) const {
  const double known = kind.seconds[indexOf(other(way_))];
  return !trial_ || seconds < 0 || known < 0 || limit_.affords(seconds - known);
}

/// Whether the other way, `way`, is worth a trial where a frame takes `here` seconds now. Large scenes are
/// tried above an OpenGL on the CPU only if that is likely to win, because no budget is saved for it.
bool EngineChoice::mayTry(Way way, const Kind& kind, double here) const {
  if (leastSeconds(way, kind) >= kFaster * here || !limit_.affords(likelyLoss(way, kind, here))) return false;
  if (way == Way::traced) return affordsTracing(kind);
  return !tooLarge(kind.load, 1) || kLikelyDirect * leastDirectSeconds(kind.load) < here;
}

/// Seconds that a trial of `way` is likely to cost where a frame takes `here` seconds now: those of the last
/// trial, or those of its precedent in relation to the way in use. If there was none, those of one frame that
/// takes twice as long: after one frame the trial can end.
double EngineChoice::likelyLoss(Way way, const Kind& kind, double here) const {
  const double known = kind.seconds[indexOf(way)], tried = kind.tried[indexOf(way)];
  const auto expected = [&] {
    if (!kind.precedent) return tried;
    const double ratio = kind.precedent->direct / kind.precedent->traced;
    return here * (way == Way::passthrough ? ratio : 1 / ratio);
  };
  const double frame = known >= 0 ? known : expected();
  return frame >= 0 ? (kTrialSettle + 1) * (frame - here) : here;
}

/// Lower bound of the seconds that a frame of this kind takes when drawn this way, measured or not: the
/// largest of leastTraceSeconds() or leastDirectSeconds() and kOptimism times the measurements of frames with
/// no more load.
double EngineChoice::leastSeconds(Way way, const Kind& kind) const {
  double least = way == Way::traced ? leastTraceSeconds(kind.load) : leastDirectSeconds(kind.load);
  for (const Kind& known : kinds_) {
    const double seconds = known.seconds[indexOf(way)];
    const bool less =
        known.load.triangles <= kSame * kind.load.triangles && known.load.pixels <= kSame * kind.load.pixels;
    if (seconds >= 0 && less) least = std::max(least, kOptimism * seconds);
  }
  return least;
}

/// Whether the budget allows a trial of tracing, by its estimated loss: the seconds that it takes longer than
/// the same number of frames of the real OpenGL, whose time was measured. A trial that likely wins needs no
/// budget. The budget that is required above an OpenGL on the CPU never exceeds its maximum; above one in
/// hardware, the loss must have been saved.
bool EngineChoice::affordsTracing(const Kind& kind) const {
  const double direct = kind.seconds[indexOf(Way::passthrough)], known = kind.seconds[indexOf(Way::traced)];
  const double likely =
      known >= 0 ? known : std::max(leastSeconds(Way::traced, kind), kLikely * leastTraceSeconds(kind.load));
  const double build = software_ || known >= 0 ? 0 : kBuildTriangle * kind.load.triangles;
  const double loss = (everTraced_ ? 0 : kFirstTrace) + build + (kTrialSettle + 1) * (likely - direct);
  return loss <= 0 || budget_.left() >= (software_ ? std::min(loss, kMaxSavedSeconds) : loss);
}

/// Seconds for triangles and pixels of an OpenGL on fast cores; nearly none in hardware. Small scenes take
/// any time.
double EngineChoice::leastDirectSeconds(const FrameLoad& load) const {
  constexpr double kTriangle = 30e-9, kPixel = 0.5e-9;
  return software_ && tooLarge(load, 1) ? kTriangle * load.triangles + kPixel * load.pixels : 0;
}

/// Seconds for the rays of an empty image and its write-back, on fast cores.
double EngineChoice::leastTraceSeconds(const FrameLoad& load) const {
  constexpr double kFrame = 0.2e-3, kRay = 14e-9, kWriteBack = 1e-9;
  return kFrame + load.pixels * (kRay / threads_ + kWriteBack);
}

}  // namespace gluray::gl
