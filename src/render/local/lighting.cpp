#include "render/local/lighting.h"

#include <cmath>

namespace gluray::render {
namespace {

constexpr float kRadiansPerDegree = 0.017453292519943295f;

glm::vec3 unit(const glm::vec3& v) {
  const float length = glm::length(v);
  return length > 0 ? v / length : glm::vec3(0);
}

PreparedLight prepare(const scene::Light& light) {
  PreparedLight p;
  p.ambient = glm::vec3(light.ambient);
  p.diffuse = glm::vec3(light.diffuse);
  p.specular = glm::vec3(light.specular);
  p.specularOn = p.specular != glm::vec3(0);
  p.directional = light.position.w == 0;
  p.position = p.directional ? unit(glm::vec3(light.position)) : glm::vec3(light.position) / light.position.w;
  p.halfVector = unit(p.position + glm::vec3(0, 0, 1));
  p.attenuated = !p.directional && light.attenuation != glm::vec3(1, 0, 0);
  p.attenuation = light.attenuation;
  p.spot = light.spotCutoff != 180.0f;
  p.spotDirection = unit(light.spotDirection);
  p.spotCosCutoff = std::cos(light.spotCutoff * kRadiansPerDegree);
  p.spotExponent = light.spotExponent;
  return p;
}

}  // namespace

Lighting::Lighting(const scene::Shading& s) : shading(&s), globalAmbient(s.globalAmbient) {
  for (const scene::FragmentLight& light : s.fragment.lights)
    coneCosines.push_back(std::cos(light.coneAngle * kRadiansPerDegree));
  if (!s.lighting) return;
  lights.reserve(s.lights.size());
  for (const scene::Light& light : s.lights) {
    lights.push_back(prepare(light));
    needsPosition |= !lights.back().directional;
  }
  needsPosition |= s.localViewer;
}

}  // namespace gluray::render
