#include "render/integrators/direct_look.h"

#include "scene/effects.h"

namespace gluray::render {
namespace {

constexpr glm::vec4 kBlack{0, 0, 0, 1};

}  // namespace

DirectLook::DirectLook(const FrameData& frame)
    : shadings(frame.shadings()), materials(frame.snapshot->instances.size()), surfaces(frame.surfaces) {
  surfaces.resize(materials.size());
  lightings.reserve(shadings.size());
  for (scene::Shading& shading : shadings) {
    shading.globalAmbient = kBlack;
    for (scene::Light& light : shading.lights) light.ambient = kBlack;
    lightings.emplace_back(shading);
  }
  for (size_t i = 0; i < surfaces.size(); ++i) {
    Surface& surface = surfaces[i];
    if (!surface.instance) continue;  // nothing to hit
    surface.lighting = &lightings[frame.shadingOf(i)];
    materials[i].assign(surface.materials, surface.materials + surface.materialCount);
    // Shader programs have ambient colours of materials alone.
    for (scene::MaterialPair& pair : materials[i]) pair.front.ambient = pair.back.ambient = kBlack;
    surface.materials = materials[i].data();
  }
}

std::unique_ptr<const DirectLook> makeDirectLook(const FrameData& frame) {
  const Settings& settings = frame.snapshot->settings;
  if (!scene::wantsOcclusion(settings) || settings.ao.on != AmbientOcclusionOn::ambient) return nullptr;
  return std::make_unique<DirectLook>(frame);
}

}  // namespace gluray::render
