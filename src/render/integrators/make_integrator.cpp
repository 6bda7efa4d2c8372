#include "render/integrators/ambient_occlusion.h"
#include "render/integrators/integrator.h"

namespace gluray::render {

std::unique_ptr<const Integrator> makeIntegrator(const FrameData& frame) {
  if (frame.honest) return nullptr;
  const auto& ao = frame.snapshot->settings.ao;
  if (!ao.enabled || ao.strength == 0) return nullptr;
  return std::make_unique<AmbientOcclusion>(frame);
}

}  // namespace gluray::render
