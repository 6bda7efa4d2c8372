// Passthrough frames: draws go to the real OpenGL as they come, and nothing is read back or kept but display
// lists. Starts and stops what EngineChoice measures. A part of each Context, GL thread.
#pragma once
#include "gl/batch/flusher.h"
#include "gl/draws/draw_counts.h"

namespace gluray::gl {

class Attention;
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
  };
  explicit PassthroughFrames(const Parts& parts) : p_(parts) {}

  /// Whether the draw that comes goes to the real OpenGL: it is counted and may be sent. Otherwise, because
  /// it is too large, the rest of the frame is drawn as ever. Of passthrough frames alone.
  bool takes(DrawPath path, PrimitiveClass kind, uint64_t triangles);
  /// The first clear or draw of a frame starts its measurement.
  void works() {
    if (p_.clock.startsMeasuring()) [[unlikely]]
      startMeasuring();
  }
  /// The frame is complete and about to be shown: ends its measurement.
  void stopMeasuring();
  /// After a frame, outside glBegin and lists: who draws the next one.
  void chooseNext();
  /// The same where the settings name another engine than before: nothing is known of its frames.
  void startAnew(Engine engine);

 private:
  void startMeasuring();
  void set(bool passthrough);

  Parts p_;
};

}  // namespace gluray::gl
