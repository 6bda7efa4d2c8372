// ProgramReader: materials, lighting models and fog.
#include "gl/program_state/program_reader.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace gluray::gl {

void ProgramReader::readMaterial(const FamilyMaterial& m, scene::Material& material) {
  const auto product = [&](const FamilyValue& intensity, const FamilyValue& color, float otherwise) {
    return uniforms_.value(intensity, glm::vec4(otherwise)) * uniforms_.value(color, glm::vec4(1));
  };
  material.ambient = product(m.ambientIntensity, m.ambientColor, m.ambientColor.given() ? 1.0f : 0.0f);
  material.diffuse = product(m.diffuseIntensity, m.diffuseColor, 1);
  material.specular = product(m.specularIntensity, m.specularColor, m.specularColor.given() ? 1.0f : 0.0f);
  // The real OpenGL optimises away uniforms that have no effect.
  const auto isOff = [&](const FamilyValue& intensity, const FamilyValue& color) {
    return !color.uniform.empty() && !uniforms_.has(color.uniform) && !uniforms_.has(intensity.uniform);
  };
  if (isOff(m.specularIntensity, m.specularColor)) material.specular = glm::vec4(0);
  if (isOff(m.ambientIntensity, m.ambientColor)) material.ambient = glm::vec4(0);
  if (m.emission.given()) material.ambient += uniforms_.value(m.emission, glm::vec4(0));
  material.emission = glm::vec4(0, 0, 0, 1);
  material.shininess = uniforms_.number(m.shininess, 0);
  material.diffuse.a = out_.known->ignoresOpacity ? 1 : uniforms_.number(m.opacity, 1);
}

bool ProgramReader::isActive(const FamilyValue& value, const FamilyValue& factor) const {
  const auto counts = [&](const FamilyValue& v) { return !v.constant.empty() || uniforms_.has(v.uniform); };
  return counts(value) || counts(factor);
}

/// VTK's programs assign all values of back faces, and then may replace some of them by values for both
/// sides. The uniforms of replaced values are not active.
void ProgramReader::readBackMaterial() {
  const scene::Material& front = out_.material.front;
  scene::Material& back = out_.material.back;
  back = front;
  const FamilyMaterial& m = family_.backMaterial;
  const FamilyValue* const values[] = {&m.ambientIntensity, &m.ambientColor,  &m.diffuseIntensity,
                                       &m.diffuseColor,     &m.specularColor, &m.specularIntensity,
                                       &m.shininess,        &m.opacity};
  const bool active = std::ranges::any_of(values, [&](auto* v) { return uniforms_.has(v->uniform); });
  out_.shading.fragment.backMaterial = active;
  if (!active) return;
  readMaterial(m, back);
  const auto replaced = [&](const FamilyValue& value, const FamilyValue& factor = {}) {
    return (value.given() || factor.given()) && !isActive(value, factor);
  };
  if (replaced(m.ambientIntensity, m.ambientColor)) back.ambient = front.ambient;
  if (replaced(m.diffuseIntensity, m.diffuseColor))
    back.diffuse = glm::vec4(glm::vec3(front.diffuse), back.diffuse.a);
  if (replaced(m.specularIntensity, m.specularColor)) back.specular = front.specular;
  if (replaced(m.shininess)) back.shininess = front.shininess;
  if (replaced(m.opacity)) back.diffuse.a = front.diffuse.a;
}

Reason ProgramReader::readBackVisibility() {
  bool& backMaterial = out_.shading.fragment.backMaterial;
  out_.hidesBackFaces = backMaterial && out_.known->discardsInvisible && out_.material.back.diffuse.a == 0;
  if (!out_.hidesBackFaces) return Reason::traced;
  // The program's peels find invisible layers, too, and then lose layers behind them.
  if (family_.pass == Family::Pass::peel) return refuse("its back faces are invisible, and are peeled");
  backMaterial = false;
  out_.material.back = out_.material.front;
  return Reason::traced;
}

void ProgramReader::readModel() {
  scene::FragmentShading& f = out_.shading.fragment;
  using Model = scene::FragmentShading::Model;
  f.model = family_.model == Family::Model::pbr     ? Model::pbr
            : family_.model == Family::Model::phong ? Model::phong
                                                    : Model::unlit;
  using Specular = scene::FragmentShading::Specular;
  f.specular = family_.lights.halfVector.given()            ? Specular::ofLight
               : family_.specular == Family::Specular::half ? Specular::half
                                                            : Specular::reflect;
  f.highlightColor = family_.lights.highlightColor;
  f.flipBackFaces = family_.flipBackFaces || uniforms_.integer(family_.flipsBackFaces) != 0;
  f.darkBackFaces = family_.darkBackFaces && !f.flipBackFaces;
  f.unitNormals = family_.unitNormals;
  f.twoSidedLights = family_.lights.twoSided;
  f.highlightsInDark = family_.lights.highlightsInDark;
  f.infiniteViewer = family_.lights.infiniteViewer || seenFromInfinity_;
  f.clampsLight = family_.lights.clamped;
  f.normalColors = family_.normalColors;
  f.facesViewer = family_.facesViewer, f.flipsTriangles = family_.flipsTriangles;
  f.backFactor = uniforms_.number(family_.backFactor, 1);
  f.encoding = uniforms_.number(family_.encoding, 1);
  f.rim.on = family_.hasRim();
  f.rim.mixes = family_.rimColor.given();
  f.rim.opacity = uniforms_.number(family_.rimOpacity, 0);
  f.rim.color = glm::vec3(uniforms_.value(family_.rimColor, glm::vec4(1)));
  f.rim.exponent = uniforms_.number(family_.rimExponent, 1);
  f.clampsColors = family_.clampedColors;
  f.ignoresAlpha = !family_.colorAlpha;
  // Inactive uniforms have no effect.
  const FamilyValue& back = family_.backColor;
  f.paintsBack = (!back.constant.empty() || uniforms_.has(back.uniform)) &&
                 (family_.backColorIf.empty() || uniforms_.integer(family_.backColorIf) != 0);
  f.backColor = glm::vec3(uniforms_.value(family_.backColor, glm::vec4(0)));
  // The sign of triangle normals that are flipped counts: they face the viewer wherever it is.
  const auto& m = out_.clipFromObject;
  const bool parallel = m[0].w == 0 && m[1].w == 0 && m[2].w == 0;
  f.parallelView =
      uniforms_.integer(family_.parallelView) != 0 || seenFromInfinity_ || (f.flipsTriangles && parallel);
}

void ProgramReader::readFog() {
  out_.shading.fog = {};
  const FamilyFog& names = family_.fog;
  const auto active = [&](const FamilyValue& v) { return !v.constant.empty() || uniforms_.has(v.uniform); };
  if (!active(names.color)) return;  // inactive uniforms have no effect
  scene::Fog& fog = out_.shading.fog;
  fog.mode = names.mode;
  if (!names.modeFrom.empty()) {
    const int mode = uniforms_.integer(names.modeFrom);
    constexpr scene::Fog::Mode kModes[] = {scene::Fog::off, scene::Fog::linear, scene::Fog::exp,
                                           scene::Fog::exp2};
    fog.mode = mode > 0 && mode < 4 ? kModes[mode] : scene::Fog::off;
  }
  fog.color = glm::vec3(uniforms_.value(names.color, glm::vec4(0)));
  fog.density = uniforms_.number(names.density, 0);
  fog.start = uniforms_.number(names.start, 0), fog.end = uniforms_.number(names.end, 0);
  fog.scaled = names.scale.given(), fog.scale = uniforms_.number(names.scale, 0);
  fog.extrapolates = names.extrapolated;
}

Reason ProgramReader::readEnabled() {
  scene::FragmentShading& f = out_.shading.fragment;
  const bool ownColors = f.color != scene::FragmentShading::Color::material;
  if (f.clampsLight && !ownColors) return refuse("it has no vertex colours, but clamps their light");
  const bool off = uniforms_.has(family_.lights.enabled) && uniforms_.integer(family_.lights.enabled) == 0;
  if (family_.lights.unlitIsMaterial && (off || f.lights.empty())) {
    f.model = scene::FragmentShading::Model::unlit;
    return Reason::traced;
  }
  if (!off) return Reason::traced;
  if (!ownColors) return refuse("it has no vertex colours to show without lights");
  f.model = scene::FragmentShading::Model::unlit;
  f.backMaterial = false;
  for (scene::Material* m : {&out_.material.front, &out_.material.back})
    m->ambient = glm::vec4(0, 0, 0, 1), m->diffuse = glm::vec4(1, 1, 1, m->diffuse.a);
  return Reason::traced;
}

}  // namespace gluray::gl
