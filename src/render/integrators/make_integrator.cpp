#include "render/ground/catcher.h"
#include "render/integrators/guides.h"
#include "render/integrators/integrator.h"
#include "render/integrators/surface_light.h"
#include "render/paths/path.h"
#include "scene/effects.h"

#include <utility>

namespace gluray::render {

namespace {

std::unique_ptr<const Integrator> makeLight(const FrameData& frame) {
  if (wantsGuide(*frame.snapshot)) return makeGuide(frame);
  if (frame.honest) return nullptr;
  const Settings& settings = frame.snapshot->settings;
  if (scene::wantsPaths(settings)) return std::make_unique<Path>(frame);
  if (!scene::wantsLight(settings) && !frame.relit) return nullptr;
  auto light = std::make_unique<SurfaceLight>(frame);
  return light->acts() ? std::move(light) : nullptr;
}

}  // namespace

std::unique_ptr<const Integrator> makeIntegrator(const FrameData& frame) {
  std::unique_ptr<const Integrator> light = makeLight(frame);
  if (frame.snapshot->catches && !wantsGuide(*frame.snapshot))
    return std::make_unique<CatcherLook>(std::move(light), CatcherLook::Catchers{.all = true});
  if (!light || !frame.averages || frame.catcher == accel::kNoHit) return light;
  return std::make_unique<CatcherLook>(std::move(light), CatcherLook::Catchers{.instance = frame.catcher});
}

}  // namespace gluray::render
