// FamilyReader: materials, lights and fog.
#include "gl/families/files/family_reader.h"

namespace gluray::gl {

void FamilyReader::readMaterial(FamilyMaterial& m) {
  value("ambient_intensity", m.ambientIntensity);
  value("ambient_color", m.ambientColor);
  value("diffuse_intensity", m.diffuseIntensity);
  value("diffuse_color", m.diffuseColor);
  value("specular_intensity", m.specularIntensity);
  value("specular_color", m.specularColor);
  value("emission_color", m.emission);
  value("shininess", m.shininess);
  value("opacity", m.opacity);
  text("unused_opacity_in_source", m.unusedOpacityInSource);
}

void FamilyReader::readLights() {
  choice("model",
         {{"unlit", Family::Model::unlit}, {"phong", Family::Model::phong}, {"pbr", Family::Model::pbr}},
         family_.model);
  FamilyLights& l = family_.lights;
  texts("names", l.names);
  name("count", l.count);
  text("count_in_source", l.countInSource);
  text("no_highlight_in_source", l.noHighlightInSource);
  name("enabled", l.enabled);
  choice("unlit_shows", {{"vertex_colors", false}, {"ambient_and_diffuse", true}}, l.unlitIsMaterial);
  name("color", l.color);
  value("direction", l.direction);
  flag("direction_towards_light", l.towardsLight);
  choice("headlight",
         {{"infinite", FamilyLights::Headlight::infinite}, {"viewer", FamilyLights::Headlight::viewer}},
         l.headlight);
  flag("two_sided", l.twoSided);
  readHighlights();
  flag("clamped", l.clamped);
  name("position", l.position);
  names("position_matrix", l.positionMatrix);
  value("intensity", l.intensity);
  value("highlight_intensity", l.highlightIntensity);
  name("positional", l.positional);
  name("attenuation", l.attenuation);
  name("cone_angle", l.coneAngle);
  name("exponent", l.exponent);
  mentionNamedLights();
}

void FamilyReader::readHighlights() {
  FamilyLights& l = family_.lights;
  choice("specular", {{"reflect", Family::Specular::reflect}, {"half", Family::Specular::half}},
         family_.specular);
  choice("highlights", {{"lit", false}, {"everywhere", true}}, l.highlightsInDark);
  lightValues("specular_color", l.specularColor);
  lightValues("shininess", l.shininess);
  readLightViewer();
  flag("highlights_need_shininess", l.highlightsNeedShininess);
  value("half_vector", l.halfVector);
  using HighlightColor = FamilyLights::HighlightColor;
  choice("highlight_color",
         {{"material", HighlightColor::material},
          {"base", HighlightColor::base},
          {"complement", HighlightColor::complement}},
         l.highlightColor);
}

void FamilyReader::readLightViewer() {
  FamilyLights& l = family_.lights;
  enum class Viewer { here, infinite, vertices };
  Viewer viewer = l.infiniteViewer ? Viewer::infinite : l.viewerAtVertices ? Viewer::vertices : Viewer::here;
  choice("viewer", {{"here", Viewer::here}, {"infinite", Viewer::infinite}, {"vertices", Viewer::vertices}},
         viewer);
  l.infiniteViewer = viewer == Viewer::infinite, l.viewerAtVertices = viewer == Viewer::vertices;
}

void FamilyReader::mentionNamedLights() {
  const FamilyLights& l = family_.lights;
  std::vector<std::string> patterns = {l.color,
                                       l.direction.uniform,
                                       l.position,
                                       l.positional,
                                       l.attenuation,
                                       l.coneAngle,
                                       l.exponent,
                                       l.halfVector.uniform,
                                       l.intensity.uniform,
                                       l.highlightIntensity.uniform};
  for (const auto* values : {&l.specularColor, &l.shininess})
    for (const FamilyValue& value : *values) patterns.push_back(value.uniform);
  for (const std::string& pattern : patterns)
    for (size_t i = 0; i < l.names.size(); ++i) mention(ofLight(pattern, l, static_cast<int>(i)));
}

void FamilyReader::readPbr() {
  FamilyPbr& p = family_.pbr;
  using Masking = scene::PbrSurface::Masking;
  choice("masking", {{"correlated", Masking::correlated}, {"separate", Masking::separate}}, p.masking);
  value("ambient", p.ambient);
  value("metallic", p.metallic);
  value("roughness", p.roughness);
  value("base_f0", p.baseF0);
  value("edge_tint", p.edgeTint);
  value("emissive", p.emissive);
  value("occlusion_strength", p.occlusionStrength);
  name("material_texture", p.materialTexture);
  name("emissive_texture", p.emissiveTexture);
  name("normal_texture", p.normalTexture);
  value("normal_scale", p.normalScale);
  name("environment_matrix", p.environmentMatrix);
  name("irradiance", p.irradiance);
  names("irradiance_harmonics", p.harmonics);
  name("prefiltered", p.prefiltered);
  text("prefiltered_max_level_in_source", p.prefilteredMaxLevelInSource);
  name("brdf_table", p.brdfTable);
  value("environment_intensity", p.environmentIntensity);
  value("multiple_scattering", p.multipleScattering);
  value("distribution_floor", p.distributionFloor);
}

void FamilyReader::readFog() {
  using Fog = scene::Fog;
  FamilyFog& f = family_.fog;
  choice("mode", {{"linear", Fog::linear}, {"exp", Fog::exp}, {"exp2", Fog::exp2}}, f.mode);
  name("mode_from", f.modeFrom);
  value("color", f.color), value("start", f.start), value("end", f.end), value("scale", f.scale);
  value("density", f.density);
  flag("extrapolated", f.extrapolated);
  choice("distance", {{"z", false}, {"absolute_z", true}}, f.absolute);
  if (!f.given()) fail(here(), "fog needs a color");
  const bool linear = f.mode == Fog::linear, any = !f.modeFrom.empty();
  if ((linear || any) && !(f.end.given() && f.start.given() != f.scale.given()))
    fail(here(), "linear fog needs end, and start or scale");
  if ((!linear || any) != f.density.given()) fail(here(), "exponential fog, and no other, needs density");
  if (!linear && !any && (f.start.given() || f.end.given() || f.scale.given() || f.extrapolated))
    fail(here(), "start, end, scale and extrapolated are for linear fog");
}

}  // namespace gluray::gl
