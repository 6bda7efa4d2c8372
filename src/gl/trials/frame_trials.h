// Measures whether skipping small draws is faster, by frames with and without it, as EngineChoice does.
// Slower trials are delayed, or end in the middle of a frame, so that their cost is a small fraction of the
// program's drawing time (TrialBudget). Calls no OpenGL and reads no clock. A part of FrameClock, GL thread.
#pragma once
#include "gl/trials/trial_budget.h"

#include <cstdint>

namespace gluray::gl {

class FrameTrials {
 public:
  enum class Way : uint8_t {
    plain,
    settling,  // boxes are made; draws are left out where they are not in the view
    culled,
  };

  /// What a frame has drawn.
  struct Load {
    double draws = 0, vertices = 0;  // small ones
    double work = 0;                 // what they cost, in units of leftOut()
    double waiting = 0;  // contents of draws, seen until now, whose boxes will be made when they come again
  };
  /// A frame begins that makes small draws; `last`: what the one before has drawn. `always`: culled, and
  /// nothing is measured.
  Way nextFrame(bool always, const Load& last);

  // --- frames that are measured
  /// Whether the frame is to be measured: finish all, and call start() before its first small draw.
  bool isMeasured() const { return measured_; }
  void start(double seconds) { startedAt_ = seconds, running_ = true; }
  /// Whether the frame is being measured: finish all, and call stop() at its end.
  bool wantsStop() const { return running_; }
  void stop(double seconds);

  // --- frames that are settling or culled
  /// Whether the draw of this number, from 0, may be left out: all are, or those of a part of the frame.
  bool takes(double draw) {
    if (over_ || draw < from_) return false;
    at_ = draw;
    return true;
  }
  /// No later draw of the frame may be.
  bool isOver() const { return over_; }
  /// Whether worked() is told what each draw costs; if not, it takes drawSeconds().
  bool isTimed() const { return way_ == Way::settling || phase_ == Phase::trying; }
  double drawSeconds() const { return drawSeconds_; }
  /// The draw that was asked for last cost so much beside drawing it.
  void worked(double seconds) { ++asked_, forDraws_ += seconds, cost(seconds); }
  /// A look at the depths cost so much. All drawing was finished `now`.
  void looked(double seconds, double now);
  /// The draw has boxes; or they are not made yet.
  void isBoxed(double vertices) { boxed_ += vertices; }
  void isUnknown() { ++unknown_; }
  /// It was left out.
  void leftOut(double work) {
    if (way_ == Way::culled) gained_ += work * secondsOfWork_;
  }

  bool pays() const { return better_ == Way::culled; }

 private:
  enum class Phase : uint8_t {
    measuring,  // plain frames
    settling,   // boxes are made
    saving,     // until there is time enough for a trial
    trying,     // culled frames are measured
    holding,    // what was faster
  };
  static constexpr double kFewDraws = 64, kFewVertices = 20'000;  // of frames that are never culled
  static constexpr double kSame = 2;        // ratio of vertices of frames that are alike
  static constexpr int kTries = 3;          // frames that are measured each way
  static constexpr int kSweeps = 4;         // over all draws, at most, to make boxes
  static constexpr double kBoxed = 0.04;    // share of vertices in boxes, below which it cannot pay
  static constexpr double kUnknown = 0.1;   // share of draws without boxes, above which they are made first
  static constexpr double kGain = 0.93;     // of the plain time, which culled frames must stay below
  static constexpr double kHopeless = 1.1;  // of the plain time
  static constexpr int kFailures = 2;       // culled frames that give up or are hopeless, which end a trial
  static constexpr double kSettling = 0.1,
                          kTrial = 0.25;  // of a plain frame: what one of the others may cost
  static constexpr double kSaved = 0.5;   // of a plain frame, saved up at most, and given at first
  static constexpr double kWeak = 0.5;    // of the gain when it was measured
  static constexpr int kWeakFrames = 8;   // after which it is measured again
  static constexpr int kRestarts = 4;     // of trials, because the load has changed
  static constexpr int kHold = 64, kLongHold = 2048;  // frames until the next trial, where it does not pay
  static constexpr int kCulledHold = 512;             // and where it does

  Way choose(const Load& last);
  void closeAccounts(const Load& last);
  void endSweep(const Load& last);
  void endCulledFrame();
  void startAnew(double vertices);
  void measureAgain(bool settled);
  void conclude(bool pays);
  void cost(double seconds) {
    spent_ += seconds;
    if (spent_ - gained_ > allowance_) over_ = true;
  }

  Phase phase_ = Phase::measuring;
  Way way_ = Way::plain, better_ = Way::plain;
  bool measured_ = false, running_ = false, always_ = false;
  int left_ = 1, interval_ = kHold / 2, restarts_ = 0, failed_ = 0;
  double load_ = 0;                                  // vertices of the frames that are compared
  double plain_ = -1, culled_ = -1, startedAt_ = 0;  // seconds; negative: not measured
  TrialBudget budget_;
  bool begun_ = false;  // it was given something

  // Of this frame.
  double from_ = 0, at_ = 0;                       // draws: the first and the last one that was asked for
  double spent_ = 0, gained_ = 0, allowance_ = 0;  // seconds
  double asked_ = 0, unknown_ = 0, forDraws_ = 0;  // draws; seconds of spent_, for them
  double boxed_ = 0, secondsOfWork_ = 0;           // vertices; seconds of a unit of work
  bool over_ = false, charged_ = false;            // charged_: spent_ is in the budget

  // Of several frames.
  bool settled_ = false;                                       // boxes were made
  bool resettled_ = false;                                     // for a second time in this trial
  int sweeps_ = 0;                                             // that have ended
  double reached_ = 0;                                         // draws of the frame that a sweep has reached
  double sweepAsked_ = 0, sweepUnknown_ = 0, sweepBoxed_ = 0;  // of this sweep
  double drawSeconds_ = 0, paid_ = 0;  // what a draw costs beside drawing; gain of a culled frame
  int weak_ = 0;                       // frames that gained much less
};

}  // namespace gluray::gl
