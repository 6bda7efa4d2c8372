#include "render/integrators/ambient_occlusion.h"
#include "render/integrators/integrator.h"
#include "render/integrators/path.h"

namespace gluray::render {

std::unique_ptr<const Integrator> makeIntegrator(const FrameData& frame) {
  const Settings& settings = frame.snapshot->settings;
  if (tracesPaths(settings)) return std::make_unique<Path>(frame);
  const bool ao = settings.ao.enabled || settings.integrator == LightIntegrator::ao;
  if (!ao || settings.ao.strength == 0) return nullptr;
  return std::make_unique<AmbientOcclusion>(frame);
}

}  // namespace gluray::render
