#include "render/integrators/ambient_occlusion.h"
#include "render/integrators/integrator.h"

namespace gluray::render {

bool wantsIntegrator(const Settings& settings) { return settings.ao.enabled && settings.ao.strength != 0; }

std::unique_ptr<const Integrator> makeIntegrator(const FrameData& frame) {
  if (!wantsIntegrator(frame.snapshot->settings)) return nullptr;
  return std::make_unique<AmbientOcclusion>(frame);
}

}  // namespace gluray::render
