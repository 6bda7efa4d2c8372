#include "render/effects/make_integrator.h"

#include "render/effects/feature_integrators.h"
#include "render/effects/surface_light.h"
#include "render/ground/catcher.h"
#include "render/integrators/integrator.h"
#include "render/paths/path_integrator.h"
#include "scene/effects.h"

#include <utility>

namespace gluray::render {

namespace {

std::unique_ptr<const SurfaceLight> makeSurfaceLight(const FrameData& frame) {
  if (!scene::wantsLight(frame.snapshot->settings) && !frame.relit) return nullptr;
  auto light = std::make_unique<SurfaceLight>(frame);
  return light->acts() ? std::move(light) : nullptr;
}

std::unique_ptr<const Integrator> makeCaught(const FrameData& frame) {
  if (auto light = makeSurfaceLight(frame)) return std::make_unique<AllCaught>(std::move(light));
  return std::make_unique<NothingCaught>();
}

std::unique_ptr<const Integrator> makeLight(const FrameData& frame) {
  if (wantsFeatures(*frame.snapshot)) return makeFeatureIntegrator(frame);
  if (frame.snapshot->catches) return makeCaught(frame);
  if (frame.honest) return nullptr;
  if (scene::wantsPaths(frame.snapshot->settings)) return std::make_unique<PathIntegrator>(frame);
  return makeSurfaceLight(frame);
}

}  // namespace

std::unique_ptr<const Integrator> makeIntegrator(const FrameData& frame) {
  std::unique_ptr<const Integrator> light = makeLight(frame);
  if (!light || !frame.averages || frame.catcher == accel::kNoHit || frame.features) return light;
  return std::make_unique<CatcherLook>(std::move(light), frame.catcher);
}

}  // namespace gluray::render
