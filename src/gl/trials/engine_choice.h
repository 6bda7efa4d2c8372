// Decides by measurement whether the ray tracer or the real OpenGL draws a context's frames faster
// (adr/0012). Decides between frames, keeps a decision for many frames, and rarely tries the alternative. A
// trial that is probably slower must fit into a time budget (TrialBudget, adr/0083), and all trials together
// into a share of the time drawn (TrialLimit, adr/0122). Begins with what earlier trials found (Precedents,
// adr/0125). Calls no OpenGL. A part of FrameClock, GL thread.
#pragma once
#include "base/clock.h"
#include "base/growing_interval.h"
#include "gl/trials/frame_load.h"
#include "gl/trials/measurement.h"
#include "gl/trials/precedents.h"
#include "gl/trials/trial_budget.h"
#include "gl/trials/trial_limit.h"
#include "settings/settings.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gluray::gl {

class EngineChoice {
 public:
  enum class Way : uint8_t {
    traced,  // draws are captured and, where possible, traced
    mixed,   // as `traced`, but small draws are rasterised: nothing is known yet, or a passthrough frame got
             // a large draw
    passthrough,  // calls go straight to the real OpenGL
  };
  using Clock = double (*)();

  struct Between {
    Engine setting = Engine::automatic;
    int threads = 1;                         // that trace
    bool software = true;                    // the real OpenGL renders on the CPU, too
    std::shared_ptr<Precedents> precedents;  // of these engines; null: none
  };
  /// The clock is read only if the setting is automatic.
  explicit EngineChoice(const Between& engines, Clock clock = nowSeconds);

  bool active() const { return active_; }
  Way way() const { return way_; }

  // --- while a frame is drawn
  /// Reports a draw of `triangles` triangles under a viewport of `viewportPixels` pixels.
  void drew(uint64_t triangles, double viewportPixels) {
    drawn_ = true;
    frame_.triangles += static_cast<double>(triangles);
    epochPixels_ = std::max(epochPixels_, viewportPixels);
  }
  /// Reports that depth was cleared: a new depth epoch begins, whose pixels count again.
  void layer() {
    frame_.pixels += epochPixels_;
    epochPixels_ = 0;
  }
  bool drawn() const { return drawn_; }
  /// Whether a draw of `triangles` triangles is left to the real OpenGL in a passthrough or mixed frame.
  bool takes(uint64_t triangles, double viewportPixels) const;
  /// As takes(), but independent of what the frame has drawn before.
  bool takesAlone(uint64_t triangles, double viewportPixels) const;
  /// Whether surfaces of `triangles` triangles that are blended in drawing order, and would be traced
  /// together, are left to the real OpenGL. Valid in frames of any kind.
  bool takesLayers(uint64_t triangles, double viewportPixels) const;
  /// Reports that the real OpenGL did not take a draw of a passthrough frame: the rest of the frame is mixed.
  void overflow();

  // --- measured frames: call glFinish before start() and before stop().
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

  /// Reports that a frame is complete, and returns how to draw the next one. Frames without draws do not
  /// count.
  Way frameEnded();

  /// Maximum number of triangles, at `pixels` pixels, that an OpenGL on the CPU draws before anything is
  /// measured. Fewer triangles compile into a list quickly, and it may draw them as fast as they are traced.
  /// An OpenGL in hardware draws any number.
  static double mostTriangles(double pixels);

 private:
  enum class Timing : uint8_t { off, wanted, running };
  enum class Phase : uint8_t { settling, measuring, holding };
  static constexpr int kTrialSettle = 2;   // frames of a trial, which the user may notice, before it measures
  static constexpr double kFaster = 0.87;  // change if the other way takes less than this share of the time
  static constexpr double kSame = Precedents::kSame;  // maximum ratio of loads of one kind

  /// Frames of similar load, and their measured cost.
  struct Kind {
    FrameLoad load;
    double seconds[2] = {-1, -1};        // traced, passthrough; negative: not measured
    double tried[2] = {-1, -1};          // the first frame of a trial that ended with it; negative: none
    std::optional<Precedent> precedent;  // until frames of this kind are measured in both ways
    double nextTrial = 0;
    GrowingInterval<double> trialInterval{4, 1024, 4};  // seconds
  };

  /// The way that is clearly faster by a kind's precedent; `otherwise` if none is.
  static Way fasterByPrecedent(const Kind& kind, Way otherwise);
  static int indexOf(Way way) { return way == Way::passthrough ? 1 : 0; }
  static Way other(Way way) { return way == Way::passthrough ? Way::traced : Way::passthrough; }
  void remember(const FrameLoad& load);
  Kind& kindOf(const FrameLoad& load);
  void enter(Kind& kind);
  void settle(Way way, bool trial);
  void permitDirect();
  void measure(int frames);
  void hold(double nextLook);
  void conclude();
  void compareWithPrecedent(Kind& kind);
  void keep(Kind& kind);
  double leastSeconds(Way way, const Kind& kind) const;
  double leastTraceSeconds(const FrameLoad& load) const;
  double leastDirectSeconds(const FrameLoad& load) const;
  bool affordsTracing(const Kind& kind) const;
  bool mayTry(Way way, const Kind& kind, double here) const;
  double likelyLoss(Way way, const Kind& kind, double here) const;
  bool isHopeless(const Kind& kind, double seconds) const;
  bool affordsAnother(const Kind& kind, double seconds) const;
  void giveUp(double seconds);
  void endTrial(bool faster);
  void account(const Kind& kind, double seconds);
  /// Whether frames are too large to be left to the real OpenGL before they were measured.
  bool tooLarge(const FrameLoad& load, double slack) const {
    return software_ && load.triangles > slack * mostTriangles(load.pixels);
  }

  bool active_;
  bool overflowed_ = false;
  int threads_;
  bool software_;
  std::shared_ptr<Precedents> precedents_;  // never null
  Clock clock_;
  Way way_;
  double mostDirect_ = 0;  // triangles of passthrough frames whose number was measured, or is being tried

  FrameLoad frame_;  // load of the frame being drawn
  double epochPixels_ = 0;
  bool drawn_ = false;
  Timing timing_ = Timing::off;
  double startedAt_ = 0, frameSeconds_ = -1;

  FrameLoad peaks_[2];  // largest loads in the current window of kWindow frames and in the previous one
  int window_ = 0;
  std::vector<Kind> kinds_;
  size_t kind_ = 0;

  Phase phase_ = Phase::settling;
  bool trial_ = false;       // the current way is not known to be faster
  bool everTraced_ = false;  // a frame was drawn by Way::traced
  TrialBudget budget_;       // for trials of tracing
  TrialLimit limit_;         // for all trials
  int settles_ = 0;          // frames until it is measured
  Measurement measured_{0};  // frames of this kind; those of another kind are failures
  double nextLook_ = 0;
  GrowingInterval<double> lookInterval_{2, 64, 2, 0};  // seconds; the first decision is checked at once
};

}  // namespace gluray::gl
