#include "render/integrators/integrator.h"
#include "render/integrators/path.h"
#include "render/integrators/surface_light.h"

namespace gluray::render {

namespace {

bool wantsOcclusion(const Settings& s) { return s.ao.enabled && s.ao.strength > 0; }
bool wantsShadows(const Settings& s) { return s.shadows.enabled && s.shadows.strength > 0; }

}  // namespace

bool areLit(const Settings& settings) { return wantsOcclusion(settings) || wantsShadows(settings); }

std::unique_ptr<const Integrator> makeIntegrator(const FrameData& frame) {
  const Settings& settings = frame.snapshot->settings;
  if (settings.integrator == LightIntegrator::path) return std::make_unique<Path>(frame);
  if (!areLit(settings) && !frame.relit) return nullptr;
  auto light = std::make_unique<SurfaceLight>(frame);
  return light->acts() ? std::move(light) : nullptr;
}

}  // namespace gluray::render
