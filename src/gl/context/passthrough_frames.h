// Passthrough frames: draws go straight to the real OpenGL, and nothing but display lists is captured. Starts
// and stops EngineChoice's measurements. A part of each Context, GL thread.
#pragma once
#include "gl/counts/draw_counts.h"
#include "gl/flush/flusher.h"

namespace gluray::gl {

class Attention;
class CulledDraws;
class WindowFrames;

class PassthroughFrames {
 public:
  struct Parts {
    ShadowState& shadow;
    Failsafe& failsafe;
    FrameClock& clock;
    DrawCounts& counts;
    ClearedFramebuffers& cleared;
    Flusher& flusher;
    WindowFrames& window;
    Attention& attention;
    CulledDraws& culled;
  };
  explicit PassthroughFrames(const Parts& parts) : p_(parts) {}

  /// In passthrough frames only: returns whether the real OpenGL shall make the next draw. A draw for which
  /// it returns true has been counted. Returns false for a draw that is too large; the rest of the frame is
  /// then captured. `more`: as DrawRequest::Load's.
  bool takes(DrawPath path, PrimitiveClass kind, uint64_t triangles, uint64_t more = 0);
  /// Call at each clear or draw: the frame's first one starts its measurement.
  void works() {
    if (p_.clock.startsMeasuring()) [[unlikely]]
      startMeasuring();
  }
  /// The frame is complete and about to be shown: ends its measurement.
  void stopMeasuring();
  /// Call after a frame, outside glBegin and list compilation: chooses who draws the next one.
  void chooseNext();
  /// The same if the setting `engine` has changed: forgets all measurements but the precedents.
  void startAnew(Engine engine);

 private:
  void startMeasuring();
  void set(bool passthrough);

  Parts p_;
};

}  // namespace gluray::gl
