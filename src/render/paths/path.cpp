#include "render/paths/path.h"

#include "render/bsdf/material_rules.h"
#include "render/lights/dome.h"
#include "render/lights/make_environment.h"
#include "render/lights/relit.h"
#include "render/local/mipmap.h"
#include "render/paths/path_vertex.h"

#include <algorithm>

namespace gluray::render {

namespace {

/// Whether surfaces that the viewer sees from the side where their corners turn counterclockwise turn the
/// other way in the window. Ordinary projections have a negative determinant: depth grows against eye space's
/// z.
bool isMirrored(const View& view) { return view.areaSign * view.away > 0; }

bool filtersTextures(const Surface& s) {
  if (!s.instance) return false;
  const scene::Shading& shading = *s.lighting->shading;
  const auto any = [](const std::vector<scene::Texture>& textures) {
    return std::any_of(textures.begin(), textures.end(), needsFootprint);
  };
  return any(shading.textures) || any(shading.fragment.pbr.textures);
}

/// The sky of a rig takes the place of the constant environment.
std::shared_ptr<const Environment> environmentOf(const FrameData& frame) {
  const Settings& s = frame.snapshot->settings;
  if (frame.relit && frame.relit->dome.shines() && s.environment.kind == EnvironmentKind::constant)
    return std::make_shared<RigSky>(frame.relit->dome, s.path.lights);
  return makeEnvironment(s, frame.snapshot->eyeFromWorld);
}

}  // namespace

Path::Path(const FrameData& of)
    : frame(of),
      metric(of),
      occluders(*of.snapshot, of.surfaces),
      lights(of),
      materials(materialsOf(*of.snapshot, metric.diagonal)),
      seen(surfaceColors(of, true)),
      captured(CapturedColors::create(of)),
      environment(environmentOf(of)),
      lightScale(of.snapshot->settings.path.lights),
      samples(of.lightSamplesEach(of.snapshot->settings.path.samples)),
      depth(of.snapshot->settings.path.depth),
      mostIndirect(of.snapshot->settings.path.clamp),
      bounces(of.snapshot->settings.integrator == LightIntegrator::path),
      mirrored(isMirrored(View(of.snapshot->camera))) {
  filters = std::any_of(of.surfaces.begin(), of.surfaces.end(), filtersTextures);
  if (paintsEdges(*of.snapshot)) unseen = surfaceColors(of, false);
  hasGlass = std::any_of(materials.begin(), materials.end(),
                         [](const MaterialModel& m) { return m.isTransparent(); });
  added = AddedLights(of, hasGlass);
  bsdf::ggxMeanAlbedo(1);  // makes its table
}

bsdf::Any Path::bsdfOf(const PathVertex& v, bool inside) const {
  const scene::FragmentShading& fragment = frame.surfaces[v.instance].lighting->shading->fragment;
  const MaterialModel& material = materials[v.instance];
  if (material.isProgram() && fragment.model == scene::FragmentShading::Model::pbr)
    return vtkBsdf(fragment.pbr, v.albedo, v.metallic, v.roughness);
  return material.bsdf(v.albedo, inside);
}

float Path::irradianceOfOne(const PathVertex& v) const {
  const scene::FragmentShading& fragment = frame.surfaces[v.instance].lighting->shading->fragment;
  return fragment.model == scene::FragmentShading::Model::pbr ? 1 : bsdf::kPi;
}

}  // namespace gluray::render
