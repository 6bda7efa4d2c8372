#include "gl/program_state/program_lights.h"

#include <algorithm>
#include <string>

namespace gluray::gl {
namespace {

glm::vec3 positionOf(const FamilyLights& names, const UniformReader& uniforms, int i) {
  const glm::vec4 given = uniforms.value({ofLight(names.position, names, i), {}}, glm::vec4(0, 0, 0, 1));
  const auto matrix = uniforms.product(names.positionMatrix);
  return glm::vec3(matrix ? glm::mat4(*matrix) * given : given);
}

/// A factor of the light's colour; 1 if the family specifies none. Inactive uniforms are 0.
float factorOf(FamilyValue value, const FamilyLights& names, const UniformReader& uniforms, int i) {
  if (!value.given()) return 1;
  value.uniform = ofLight(value.uniform, names, i);
  return uniforms.number(value, 0);
}

scene::FragmentLight readLight(const FamilyLights& names, const UniformReader& uniforms,
                               const glm::vec3& viewer, int i) {
  const auto vector = [&](const std::string& name) {
    return glm::vec3(uniforms.vector(ofLight(name, names, i)));
  };
  const auto has = [&](const std::string& name) { return uniforms.has(ofLight(name, names, i)); };
  scene::FragmentLight light;
  if (!names.color.empty())
    light.color = glm::vec3(uniforms.value({ofLight(names.color, names, i), {}}, glm::vec4(0)));
  if (const bool constant = !names.direction.constant.empty(); constant || has(names.direction.uniform)) {
    const glm::vec3 given =
        constant ? glm::vec3(uniforms.value(names.direction, glm::vec4(0))) : vector(names.direction.uniform);
    const glm::vec3 direction = given * (names.towardsLight ? -1.0f : 1.0f);
    light.kind = scene::FragmentLight::directional;
    if (direction != glm::vec3(0)) light.direction = glm::normalize(direction);
  }
  const bool positional = names.positional.empty()
                              ? has(names.position)
                              : uniforms.integer(ofLight(names.positional, names, i)) != 0;
  const bool atViewer = names.headlight == FamilyLights::Headlight::viewer &&
                        light.kind == scene::FragmentLight::headlight && !has(names.position);
  if (!positional && !atViewer) return light;
  light.kind = scene::FragmentLight::positional;
  if (atViewer) return light;  // the viewer is the origin
  light.position = positionOf(names, uniforms, i) - viewer;
  if (has(names.attenuation)) light.attenuation = vector(names.attenuation);
  if (has(names.coneAngle)) light.coneAngle = uniforms.number(ofLight(names.coneAngle, names, i));
  if (has(names.exponent)) light.exponent = uniforms.number(ofLight(names.exponent, names, i));
  return light;
}

/// The value for light `i`; `otherwise` if the family specifies none. Inactive uniforms are 0.
glm::vec4 valueOf(const std::vector<FamilyValue>& values, const FamilyLights& names,
                  const UniformReader& uniforms, int i, const glm::vec4& otherwise) {
  if (values.empty()) return otherwise;
  FamilyValue value = values[std::min(static_cast<size_t>(i), values.size() - 1)];
  value.uniform = ofLight(value.uniform, names, i);
  return uniforms.value(value, glm::vec4(0));
}

void readHighlight(const FamilyLights& names, const UniformReader& uniforms, float shininess, int i,
                   scene::FragmentLight& light) {
  if (names.halfVector.given())
    light.half = glm::vec3(valueOf({names.halfVector}, names, uniforms, i, glm::vec4(0)));
  const glm::vec3 color = light.color;
  light.color *= factorOf(names.intensity, names, uniforms, i);
  const bool factor = names.highlightIntensity.given();
  light.ownHighlight = factor || !names.specularColor.empty() || !names.shininess.empty();
  if (!light.ownHighlight) return;
  light.highlight =
      factor ? color * factorOf(names.highlightIntensity, names, uniforms, i)
             : glm::vec3(valueOf(names.specularColor, names, uniforms, i, glm::vec4(light.color, 1)));
  light.shininess = valueOf(names.shininess, names, uniforms, i, glm::vec4(shininess)).x;
}

}  // namespace

std::vector<scene::FragmentLight> readLights(const FamilyLights& names, const UniformReader& uniforms,
                                             const glm::vec3& viewer, float shininess,
                                             const KnownProgram& known) {
  int most = known.lightCount;
  std::vector<scene::FragmentLight> lights;
  const std::string& sign = !names.color.empty()               ? names.color
                            : !names.direction.uniform.empty() ? names.direction.uniform
                                                               : names.position;
  const auto read = [&](int i) {
    scene::FragmentLight light = readLight(names, uniforms, viewer, i);
    readHighlight(names, uniforms, shininess, i, light);
    if (known.highlightCount >= 0 && i >= known.highlightCount)
      light.ownHighlight = true, light.highlight = glm::vec3(0);
    return light;
  };
  if (sign.empty() && names.direction.given()) return {read(0)};
  const bool many = sign.find("{}") != std::string::npos;
  constexpr int kMaxLights = 64;
  if (!names.names.empty()) most = static_cast<int>(names.names.size());
  most = std::min(most < 0 ? kMaxLights : most, many ? kMaxLights : 1);
  if (uniforms.has(names.count)) most = std::min(most, uniforms.integer(names.count));
  for (int i = 0; i < most && uniforms.has(ofLight(sign, names, i)); ++i) lights.push_back(read(i));
  return lights;
}

}  // namespace gluray::gl
