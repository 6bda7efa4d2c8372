// Decides whether the ray tracer or the real OpenGL draws a context's frames: whichever is faster by
// measurement (adr/0012). Decides between frames, keeps a decision for many frames, and rarely tries the
// alternative. If the alternative is probably slower, it tries only within the time budget (TrialBudget,
// adr/0083). Calls no OpenGL. A part of FrameClock, GL thread.
#pragma once
#include "base/clock.h"
#include "gl/trials/trial_budget.h"
#include "settings/settings.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

/// The work in a frame.
struct FrameLoad {
  double triangles = 0;  // of surfaces
  double pixels = 0;     // sum over the depth epochs of the largest viewport's pixels
  bool operator==(const FrameLoad&) const = default;
};

class EngineChoice {
 public:
  enum class Way : uint8_t {
    traced,  // draws are captured and, where possible, traced
    mixed,   // the same, but small draws are rasterised: nothing is known yet, or a passthrough frame got a
             // large draw
    passthrough,  // calls go straight to the real OpenGL
  };
  using Clock = double (*)();

  /// `threads`: number of tracing threads. The clock is read only if `setting` is automatic.
  EngineChoice(Engine setting, int threads, Clock clock = nowSeconds);

  bool active() const { return active_; }
  Way way() const { return way_; }

  // --- while a frame is drawn
  /// A draw of `triangles` triangles under a viewport of `viewportPixels` pixels.
  void drew(uint64_t triangles, double viewportPixels) {
    drawn_ = true;
    frame_.triangles += static_cast<double>(triangles);
    epochPixels_ = std::max(epochPixels_, viewportPixels);
  }
  /// Depth was cleared: a new depth epoch, whose pixels count again.
  void layer() {
    frame_.pixels += epochPixels_;
    epochPixels_ = 0;
  }
  bool drawn() const { return drawn_; }
  /// Whether the real OpenGL takes a draw of so many triangles in a passthrough or mixed frame.
  bool takes(uint64_t triangles, double viewportPixels) const;
  /// The same, whatever has been drawn before in the frame.
  bool takesAlone(uint64_t triangles, double viewportPixels) const;
  /// Whether, in frames of any kind, the real OpenGL takes so many triangles of surfaces that are blended in
  /// drawing order and would be traced together.
  bool takesLayers(uint64_t triangles, double viewportPixels) const;
  /// The real OpenGL did not take a draw of a passthrough frame: the rest of the frame is mixed.
  void overflow();

  // --- frames that are measured: call glFinish before start() and before stop().
  bool wantsStart() const { return timing_ == Timing::wanted; }
  void start() {
    startedAt_ = clock_();
    timing_ = Timing::running;
  }
  bool wantsStop() const { return timing_ == Timing::running; }
  void stop() {
    frameSeconds_ = clock_() - startedAt_;
    timing_ = Timing::off;
  }

  /// A frame is complete: returns how to draw the next. Frames without draws do not count.
  Way frameEnded();

  /// The most triangles with which the real OpenGL is tried at so many pixels. Fewer compile into a list in
  /// an instant, and the real OpenGL may draw them as fast as they are traced.
  static double mostTriangles(double pixels);

 private:
  enum class Timing : uint8_t { off, wanted, running };
  enum class Phase : uint8_t { settling, measuring, holding };

  /// Frames of similar load, and their measured cost.
  struct Kind {
    FrameLoad load;
    double seconds[2] = {-1, -1};  // traced, passthrough; negative: not measured
    double nextTrial = 0, trialInterval = 0;
  };

  static int indexOf(Way way) { return way == Way::passthrough ? 1 : 0; }
  static Way other(Way way) { return way == Way::passthrough ? Way::traced : Way::passthrough; }
  void remember(const FrameLoad& load);
  Kind& kindOf(const FrameLoad& load);
  void enter(Kind& kind);
  void settle(Way way, bool trial);
  void measure(int frames);
  void rest();
  void hold();
  void conclude();
  double leastSeconds(Way way, const Kind& kind) const;
  double leastTraceSeconds(const FrameLoad& load) const;
  double likelyLoss(const Kind& kind) const;
  bool affords(double loss) const;
  bool isHopeless(const Kind& kind, double seconds) const;
  void account(const Kind& kind, double seconds);
  bool tooLarge(const FrameLoad& load, double slack) const {
    return load.triangles > slack * mostTriangles(load.pixels);
  }

  bool active_;
  bool overflowed_ = false;
  int threads_;
  Clock clock_;
  Way way_;

  FrameLoad frame_;  // of the frame being drawn
  double epochPixels_ = 0;
  bool drawn_ = false;
  Timing timing_ = Timing::off;
  double startedAt_ = 0, frameSeconds_ = -1;

  FrameLoad peaks_[2];  // largest loads in this window of kWindow frames and in the one before
  int window_ = 0;
  std::vector<Kind> kinds_;
  size_t kind_ = 0;

  Phase phase_ = Phase::settling;
  bool trial_ = false;       // trying a way that is not known to be faster
  bool everTraced_ = false;  // a frame was drawn by Way::traced
  TrialBudget budget_;       // for trials of tracing
  int left_ = 0;             // frames left in this phase
  int attempts_ = 0;         // frames measured that were of another kind
  double best_ = -1;         // fastest measured frame of this kind, seconds
  double nextLook_ = 0, lookInterval_ = 0;
};

}  // namespace gluray::gl
