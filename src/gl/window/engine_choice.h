// Whether the ray tracer or the real OpenGL draws the frames of a context: whichever was measured to be
// faster. Decides between frames, holds for many, and tries the other one rarely. Knows no OpenGL; Context
// asks it. GL thread.
#pragma once
#include "base/clock.h"
#include "settings/settings.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace gluray::gl {

/// What a frame asks of whoever draws it.
struct FrameLoad {
  double triangles = 0;  // of surfaces
  double pixels = 0;     // of the viewports: the largest of each layer, summed
  bool operator==(const FrameLoad&) const = default;
};

class EngineChoice {
 public:
  enum class Way : uint8_t {
    traced,  // draws are captured and traced where they can be
    mixed,   // the same, but small draws are rasterised: nothing is known yet, or a passthrough frame met a
             // large draw
    passthrough,  // calls go to the real OpenGL as they come
  };
  using Clock = double (*)();

  /// `threads` trace. The clock is read only where `setting` leaves a choice.
  EngineChoice(Engine setting, int threads, Clock clock = nowSeconds);

  bool active() const { return active_; }
  Way way() const { return way_; }

  // --- while a frame is drawn
  /// A draw of so many triangles under a viewport of so many pixels.
  void drew(uint64_t triangles, double viewportPixels) {
    drawn_ = true;
    frame_.triangles += static_cast<double>(triangles);
    layerPixels_ = std::max(layerPixels_, viewportPixels);
  }
  /// Depth was cleared: what follows covers the viewport once more.
  void layer() {
    frame_.pixels += layerPixels_;
    layerPixels_ = 0;
  }
  bool drawn() const { return drawn_; }
  /// Whether the real OpenGL takes a draw of so many triangles, in a passthrough or mixed frame.
  bool takes(uint64_t triangles, double viewportPixels) const;
  /// The same, whatever has been drawn before.
  bool takesAlone(uint64_t triangles, double viewportPixels) const;
  /// Whether it takes so many triangles of surfaces that are blended in the order of drawing, which wait to
  /// be traced together, in frames of any kind.
  bool takesLayers(uint64_t triangles, double viewportPixels) const;
  /// It does not take one in a passthrough frame: the rest of the frame is mixed.
  void overflow();

  // --- frames that are measured: the real OpenGL is to finish before start() and before stop().
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

  /// A frame is complete: says how the next is drawn. Frames in which nothing was drawn do not count.
  Way frameEnded();

  /// Most triangles that the real OpenGL is tried with, at so many pixels: those whose lists it compiles in
  /// an instant and that it has a chance to draw as fast as they are traced.
  static double mostTriangles(double pixels);

 private:
  enum class Timing : uint8_t { off, wanted, running };
  enum class Phase : uint8_t { settling, measuring, holding };

  /// Frames of about one load, and what they cost.
  struct Kind {
    FrameLoad load;
    double seconds[2] = {-1, -1};  // by traced, passthrough; negative: not measured
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
  bool tooLarge(const FrameLoad& load, double slack) const {
    return load.triangles > slack * mostTriangles(load.pixels);
  }

  bool active_;
  bool overflowed_ = false;
  int threads_;
  Clock clock_;
  Way way_;

  FrameLoad frame_;  // the frame that is being drawn
  double layerPixels_ = 0;
  bool drawn_ = false;
  Timing timing_ = Timing::off;
  double startedAt_ = 0, frameSeconds_ = -1;

  FrameLoad peaks_[2];  // largest loads of this window of frames and of the one before
  int window_ = 0;
  std::vector<Kind> kinds_;
  size_t kind_ = 0;

  Phase phase_ = Phase::settling;
  bool trial_ = false;  // of a way that is not yet known to be faster
  int left_ = 0;        // frames of this phase
  int attempts_ = 0;    // frames measured that were not of this kind
  double best_ = -1;    // of those that were
  double nextLook_ = 0, lookInterval_ = 0;
};

}  // namespace gluray::gl
