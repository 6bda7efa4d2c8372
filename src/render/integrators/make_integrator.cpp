#include "render/integrators/guides.h"
#include "render/integrators/integrator.h"
#include "render/integrators/surface_light.h"
#include "render/paths/path.h"
#include "scene/effects.h"

namespace gluray::render {

std::unique_ptr<const Integrator> makeIntegrator(const FrameData& frame) {
  if (wantsGuide(*frame.snapshot)) return makeGuide(frame);
  if (frame.honest) return nullptr;
  const Settings& settings = frame.snapshot->settings;
  if (scene::wantsPaths(settings)) return std::make_unique<Path>(frame);
  if (!scene::wantsLight(settings) && !frame.relit) return nullptr;
  auto light = std::make_unique<SurfaceLight>(frame);
  return light->acts() ? std::move(light) : nullptr;
}

}  // namespace gluray::render
