// Decides by measurement whether culling small draws makes frames faster, as EngineChoice decides for
// engines. Trials that would be slower wait until the budget allows them, or end in the middle of a frame, so
// that they cost a small fraction of the program's drawing time (TrialBudget). Calls no OpenGL and reads no
// clock. A part of SmallDraws, GL thread.
#pragma once
#include "base/growing_interval.h"
#include "gl/trials/measurement.h"
#include "gl/trials/trial_budget.h"

#include <cstdint>

namespace gluray::gl {

class FrameTrials {
 public:
  enum class Way : uint8_t {
    plain,
    settling,  // bounding boxes are computed; only draws outside the view volume are skipped
    culled,
  };

  /// Load of a frame.
  struct Load {
    double draws = 0, vertices = 0;  // of small draws
    double work = 0;                 // cost of the small draws, in units of leftOut()
    double waiting = 0;              // new contents, whose boxes are computed when they recur
  };
  /// Begins a frame with small draws. `last`: load of the previous frame. `always`: culled, without
  /// measuring.
  Way nextFrame(bool always, const Load& last);

  // --- measured frames
  /// Whether to measure the frame: finish all drawing, and call start() before its first small draw.
  bool isMeasured() const { return measured_; }
  void start(double seconds) { startedAt_ = seconds, running_ = true; }
  /// Whether the frame is being measured: finish all drawing, and call stop() at its end.
  bool wantsStop() const { return running_; }
  void stop(double seconds);

  // --- settling and culled frames
  /// Whether draw number `draw` of the frame, from 0, may be skipped: draws from some number on may be, until
  /// the frame's budget is spent.
  bool takes(double draw) {
    if (over_ || draw < from_) return false;
    at_ = draw;
    return true;
  }
  /// Whether the frame's budget is spent: no later draw of the frame may be skipped.
  bool isOver() const { return over_; }
  /// Whether to pass the measured time of each draw to worked(). Otherwise pass drawSeconds().
  bool isTimed() const { return way_ == Way::settling || phase_ == Phase::trying; }
  double drawSeconds() const { return drawSeconds_; }
  /// Reports the time spent on the last draw for which takes() returned true, without drawing it.
  void worked(double seconds) { ++asked_, forDraws_ += seconds, cost(seconds); }
  /// Reports the time of a depth read. At time `now` all drawing was finished.
  void looked(double seconds, double now);
  /// Reports that the draw has a bounding box of `vertices` vertices.
  void isBoxed(double vertices) { boxed_ += vertices; }
  /// Reports that the draw has no bounding box yet.
  void isUnknown() { ++unknown_; }
  /// Reports that the draw was skipped.
  void leftOut(double work) {
    if (way_ == Way::culled) gained_ += work * secondsOfWork_;
  }

  bool pays() const { return better_ == Way::culled; }

 private:
  enum class Phase : uint8_t {
    measuring,  // plain frames
    settling,   // boxes are computed
    saving,     // until the budget allows a trial
    trying,     // culled frames are measured
    holding,    // the faster way is used
  };
  static constexpr double kFewDraws = 64, kFewVertices = 20'000;  // frames with less are never culled
  static constexpr double kSame = 2;        // maximum ratio of vertices of similar frames
  static constexpr int kTries = 3;          // frames measured for each way
  static constexpr int kSweeps = 4;         // maximum number of passes over all draws to compute boxes
  static constexpr double kBoxed = 0.04;    // minimum share of vertices in boxes for which culling can pay
  static constexpr double kUnknown = 0.1;   // share of draws without boxes above which these come first
  static constexpr double kGain = 0.93;     // of the plain time: limit below which culling pays
  static constexpr double kHopeless = 1.1;  // times the plain time
  static constexpr int kFailures = 2;       // failed or hopeless culled frames until a trial ends
  static constexpr double kSettling = 0.1,
                          kTrial = 0.25;  // maximum cost of these frames, as a share of a plain one
  static constexpr double kSaved = 0.5;   // maximum and initial budget, as a share of a plain frame
  static constexpr double kWeak = 0.5;    // share of the measured gain below which a frame is weak
  static constexpr int kWeakFrames = 8;   // weak frames until culling is measured again
  static constexpr int kRestarts = 4;     // maximum restarts of trials because the load has changed
  static constexpr int kHold = 64, kLongHold = 2048;  // frames until the next trial, if culling does not pay
  static constexpr int kCulledHold = 512;             // likewise, if it pays

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
  int hold_ = 0, restarts_ = 0;  // frames until this phase ends; restarts
  GrowingInterval<int> again_{kHold, kLongHold};
  double load_ = 0;  // vertices of the frames being compared
  Measurement plain_{1}, culled_{kTries};
  double startedAt_ = 0;  // seconds
  TrialBudget budget_;
  bool begun_ = false;  // the initial budget was added

  // Of the current frame.
  double from_ = 0, at_ = 0;                       // the first draw that may be skipped; the last one queried
  double spent_ = 0, gained_ = 0, allowance_ = 0;  // seconds
  double asked_ = 0, unknown_ = 0, forDraws_ = 0;  // draws; the part of spent_ for draws, in seconds
  double boxed_ = 0, secondsOfWork_ = 0;           // vertices; seconds of a unit of work
  bool over_ = false, charged_ = false;            // charged_: spent_ was charged to the budget

  // Across frames.
  bool settled_ = false;                                       // boxes were computed
  bool resettled_ = false;                                     // a second time in this trial
  int sweeps_ = 0;                                             // completed passes
  double reached_ = 0;                                         // number of the draw that a pass has reached
  double sweepAsked_ = 0, sweepUnknown_ = 0, sweepBoxed_ = 0;  // of this pass
  double drawSeconds_ = 0, paid_ = 0;  // seconds per draw beside drawing; gain of a measured culled frame
  int weak_ = 0;                       // consecutive frames that gained much less
};

}  // namespace gluray::gl
