#include "gl/clock/frame_clock.h"

#include "gl/clock/frame_settings.h"

namespace gluray::gl {

FrameClock::FrameClock(const ContextInfo& info, const Settings& settings)
    : choice({engineOf(info, settings), threadsOf(settings), info.software, info.precedents}, info.clock),
      info_(info),
      passesThrough_(!info.off && choice.way() == EngineChoice::Way::passthrough) {}

bool FrameClock::isShown() const { return info_.isShown && info_.isShown(); }

scene::LightSampling::Mode FrameClock::lightMode(const Settings& settings) {
  using Sampling = scene::LightSampling;
  isOffscreen_ = animates_ = false;
  return settings.changesImage() && isShown() ? Sampling::Mode::moving : Sampling::Mode::full;
}

bool FrameClock::watchesOffscreen(const Settings& settings) const {
  return settings.refine.offscreen == RefineOffscreen::animated && settings.changesImage() && !isShown();
}

scene::LightSampling::Mode FrameClock::offscreenMode(glm::ivec2 size, uint64_t viewFrame) {
  using Sampling = scene::LightSampling;
  isOffscreen_ = true;
  animates_ = offscreen_.isAnimated(size, frame + viewFrame, nowSeconds());
  return animates_ ? Sampling::Mode::moving : Sampling::Mode::full;
}

}  // namespace gluray::gl
