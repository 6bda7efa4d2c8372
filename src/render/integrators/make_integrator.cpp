#include "render/integrators/integrator.h"
#include "render/integrators/surface_light.h"

namespace gluray::render {

std::unique_ptr<const Integrator> makeIntegrator(const FrameData& frame) {
  const Settings& settings = frame.snapshot->settings;
  const bool occludes = settings.ao.enabled && settings.ao.strength > 0,
             shadows = settings.shadows.enabled && settings.shadows.strength > 0;
  if (!occludes && !shadows && !frame.relit) return nullptr;
  auto light = std::make_unique<SurfaceLight>(frame);
  return light->acts() ? std::move(light) : nullptr;
}

}  // namespace gluray::render
