// Whether leaving out small draws pays: frames with and without it are measured, as EngineChoice measures
// frames. Calls no OpenGL. A part of FrameClock, GL thread.
#pragma once
#include <algorithm>
#include <cstdint>

namespace gluray::gl {

class FrameTrials {
 public:
  enum class Way : uint8_t { plain, culled };

  /// What a frame has drawn.
  struct Load {
    double draws = 0, vertices = 0;  // small ones
    double leftOut = 0;              // vertices, of them
    bool unknown = false;            // some were drawn because there was no time for their boxes
  };
  /// A frame begins that makes small draws; `last`: what the one before has drawn. `always`: culled, and
  /// nothing is measured.
  Way next(bool always, const Load& last) {
    running_ = measured_ = false;
    if (always) return Way::culled;
    if (last.draws < kFewDraws || last.vertices < kFewVertices) return Way::plain;
    if (last.vertices > kSame * load_ || load_ > kSame * last.vertices) startAnew(last.vertices);
    switch (phase_) {
      case Phase::plain: measured_ = true; return Way::plain;
      case Phase::settling: return settle(last);
      case Phase::culled: measured_ = true; return Way::culled;
      case Phase::holding:
        if (--left_ <= 0) phase_ = Phase::plain, left_ = kTries, plain_ = culled_ = -1;
        return better_;
    }
    return Way::plain;
  }
  /// Whether the frame is to be measured: finish all, and call start() before its first small draw.
  bool isMeasured() const { return measured_; }
  void start(double seconds) { startedAt_ = seconds, running_ = true; }
  /// Whether the frame is being measured: finish all, and call stop() at its end.
  bool wantsStop() const { return running_; }
  void stop(double seconds) {
    running_ = false;
    double& best = phase_ == Phase::plain ? plain_ : culled_;
    const double took = seconds - startedAt_;
    best = best < 0 ? took : std::min(best, took);
    if (--left_ > 0) return;
    if (phase_ == Phase::plain)
      phase_ = Phase::settling, left_ = kSettle;
    else
      conclude();
  }
  bool pays() const { return better_ == Way::culled; }
  /// Whether it is about to be measured: what it needs may be made at once.
  bool settles() const { return phase_ == Phase::settling; }

 private:
  enum class Phase : uint8_t { plain, settling, culled, holding };
  static constexpr double kFewDraws = 64, kFewVertices = 20'000;  // of frames that are never culled
  static constexpr double kSame = 2;             // ratio of vertices of frames that are alike
  static constexpr int kTries = 3, kSettle = 8;  // frames; boxes are made while they settle
  static constexpr int kLongSettle = 32,
                       kSeen = 4;          // at most; after which it shows whether anything is hidden
  static constexpr double kHidden = 0.04;  // share of vertices left out, below which it cannot pay
  static constexpr double kGain = 0.93;    // of the plain time, which culled frames must stay below
  static constexpr int kHold = 64, kLongHold = 2048;  // frames until the next trial

  void startAnew(double vertices) {
    // Where culling does not pay, a changing scene must not bring it back at once.
    if (phase_ == Phase::holding && better_ == Way::plain && left_ > kHold) left_ = kHold;
    load_ = vertices;
    if (phase_ == Phase::holding && better_ == Way::plain) return;
    phase_ = Phase::plain, left_ = kTries, plain_ = culled_ = -1;
  }
  Way settle(const Load& last) {
    if (last.unknown && settled_ < kLongSettle) return ++settled_, left_ = kSettle, Way::culled;
    ++settled_;
    if (left_ <= kSettle - kSeen && last.leftOut < kHidden * last.vertices)
      return conclude(false), Way::plain;
    if (--left_ <= 0) phase_ = Phase::culled, left_ = kTries, settled_ = 0;
    return Way::culled;
  }
  void conclude() { conclude(culled_ < kGain * plain_); }
  void conclude(bool pays) {
    settled_ = 0;
    interval_ = pays ? kHold : std::min(2 * interval_, kLongHold);
    phase_ = Phase::holding, left_ = pays ? kLongHold : interval_;
    better_ = pays ? Way::culled : Way::plain;
  }

  Phase phase_ = Phase::plain;
  Way better_ = Way::plain;
  bool measured_ = false, running_ = false;
  int left_ = kTries, interval_ = kHold / 2, settled_ = 0;
  double load_ = 0;                                  // vertices of the frames that are compared
  double plain_ = -1, culled_ = -1, startedAt_ = 0;  // seconds; negative: not measured
};

}  // namespace gluray::gl
