// The frames of a context: their number, when the present one began, and who draws it. A part of each
// Context, GL thread.
#pragma once
#include "gl/context_info.h"
#include "gl/window/engine_choice.h"

#include <cstdint>

namespace gluray::gl {

class FrameClock {
 public:
  FrameClock(const ContextInfo& info, const Settings& settings);

  uint64_t frame = 1;
  double beganSeconds = 0;  // when this frame was first seen to clear or draw; 0: not yet
  EngineChoice choice;

  /// Whether draws go to the real OpenGL as they come. Then nothing is read back or kept but display lists.
  bool passesThrough() const { return passesThrough_; }
  void setPassthrough(bool passesThrough) { passesThrough_ = passesThrough; }
  /// Whether this frame's duration is measured, so that nothing may be shown again or later.
  bool measured() const { return choice.wantsStop(); }
  bool startsMeasuring() const { return choice.wantsStart(); }
  /// Whether a surface of so many triangles is left to the real OpenGL, however much there is in all.
  bool leavesAlone(uint64_t triangles, double viewportPixels) const {
    return choice.way() == EngineChoice::Way::mixed && choice.takesAlone(triangles, viewportPixels);
  }
  /// The same of surfaces that are blended in the order of drawing.
  bool leavesLayers(uint64_t triangles, double viewportPixels) const {
    return choice.takesLayers(triangles, viewportPixels);
  }

 private:
  bool passesThrough_ = false;
};

}  // namespace gluray::gl
