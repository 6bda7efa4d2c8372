#include "render/bsdf/material_model.h"

#include "render/bsdf/metals.h"

namespace gluray::render {
namespace {

const bsdf::Metal& metalOf(SurfaceMetal metal) {
  switch (metal) {
    case SurfaceMetal::silver: return bsdf::kSilver;
    case SurfaceMetal::gold: return bsdf::kGold;
    case SurfaceMetal::chromium: return bsdf::kChromium;
    case SurfaceMetal::copper: return bsdf::kCopper;
    case SurfaceMetal::iron: return bsdf::kIron;
    case SurfaceMetal::aluminium: break;
  }
  return bsdf::kAluminium;
}

}  // namespace

MaterialModel MaterialModel::fromSettings(const Settings& settings, float diagonal) {
  const auto& m = settings.material;
  MaterialModel model;
  model.kind = m.kind, model.metal = m.metal;
  model.roughness = m.roughness, model.ior = m.ior;
  model.metallic = m.metallic, model.specular = m.specular;
  model.transmission = m.transmission, model.coat = m.coat;
  model.emission = m.emission;
  model.absorption = m.absorption * diagonal;
  return model;
}

bsdf::Any MaterialModel::bsdf(const glm::vec3& color, bool inside) const {
  const bsdf::Ggx ggx = bsdf::Ggx::ofRoughness(roughness);
  const float eta = inside ? 1 / ior : ior;
  // Light passes two surfaces of a body: together they have its colour.
  const glm::vec3 tint = absorption > 0 ? glm::vec3(1) : glm::sqrt(color);
  switch (kind) {
    case SurfaceMaterial::plastic: return bsdf::Plastic{color, bsdf::reflectanceAtNormal(ior), ggx};
    case SurfaceMaterial::metal: return bsdf::Conductor{metalOf(metal).eta, metalOf(metal).k, ggx, color};
    case SurfaceMaterial::glass: return bsdf::Dielectric{eta, ggx, tint};
    case SurfaceMaterial::thinGlass: return bsdf::ThinDielectric{ior, color};
    case SurfaceMaterial::mirror: return bsdf::Mirror{color};
    case SurfaceMaterial::principled:
      return bsdf::Principled{color, metallic, specular, transmission, coat, eta, ggx};
    case SurfaceMaterial::matte: return bsdf::OrenNayar{color, roughness};
    case SurfaceMaterial::emissive: return bsdf::Lambert{glm::vec3(0)};
    case SurfaceMaterial::program: break;
  }
  return bsdf::Lambert{color};
}

bsdf::VtkPbr vtkBsdf(const scene::PbrSurface& pbr, const glm::vec3& color, float metallic, float roughness) {
  return {color, metallic, roughness, pbr.baseF0, pbr.edgeTint, pbr.distributionFloor};
}

}  // namespace gluray::render
