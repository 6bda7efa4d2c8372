#include "gl/window/frame_clock.h"

#include "gl/window/frame_settings.h"

namespace gluray::gl {

FrameClock::FrameClock(const ContextInfo& info, const Settings& settings)
    : choice(engineOf(info, settings), threadsOf(settings), info.clock),
      passesThrough_(!info.off && choice.way() == EngineChoice::Way::passthrough) {}

}  // namespace gluray::gl
