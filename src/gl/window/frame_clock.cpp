#include "gl/window/frame_clock.h"

#include "gl/window/frame_settings.h"

namespace gluray::gl {

FrameClock::FrameClock(const ContextInfo& info, const Settings& settings)
    : choice(engineOf(info, settings), threadsOf(settings), info.clock),
      info_(info),
      passesThrough_(!info.off && choice.way() == EngineChoice::Way::passthrough) {}

scene::LightSampling::Mode FrameClock::lightMode(const Settings& settings) const {
  using Sampling = scene::LightSampling;
  return settings.changesPicture() && info_.isShown && info_.isShown() ? Sampling::Mode::moving
                                                                       : Sampling::Mode::full;
}

}  // namespace gluray::gl
