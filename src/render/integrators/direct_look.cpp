#include "render/integrators/direct_look.h"

#include "render/integrators/integrator.h"

namespace gluray::render {
namespace {

constexpr glm::vec4 kNone{0, 0, 0, 1};

}  // namespace

DirectLook::DirectLook(const FrameData& frame)
    : shadings(frame.snapshot->shadings), materials(frame.surfaces.size()), surfaces(frame.surfaces) {
  lightings.reserve(shadings.size());
  for (scene::Shading& shading : shadings) {
    shading.globalAmbient = kNone;
    for (scene::Light& light : shading.lights) light.ambient = kNone;
    lightings.emplace_back(shading);
  }
  for (size_t i = 0; i < surfaces.size(); ++i) {
    Surface& surface = surfaces[i];
    if (!surface.instance) continue;  // nothing to hit
    surface.lighting = &lightings[surface.instance->shading];
    materials[i].assign(surface.materials, surface.materials + surface.materialCount);
    // Shader programs have ambient colours of materials alone.
    for (scene::MaterialPair& pair : materials[i]) pair.front.ambient = pair.back.ambient = kNone;
    surface.materials = materials[i].data();
  }
}

std::unique_ptr<const DirectLook> makeDirectLook(const FrameData& frame) {
  const Settings& settings = frame.snapshot->settings;
  const bool ao = settings.ao.enabled || settings.integrator == LightIntegrator::ao;
  if (!ao || tracesPaths(settings) || settings.ao.on != AmbientOcclusionOn::ambient) return nullptr;
  return std::make_unique<DirectLook>(frame);
}

}  // namespace gluray::render
