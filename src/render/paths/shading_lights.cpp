#include "render/paths/shading_lights.h"

#include "render/lights/relit.h"
#include "render/local/lighting_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gluray::render {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

bool isProgram(const Surface& s) { return isProgram(*s.lighting->shading); }

float attenuation(const glm::vec3& factors, float distance) {
  return 1 / (factors.x + distance * (factors.y + distance * factors.z));
}

float inCone(float cosine, float least, float exponent) {
  if (!(cosine >= least)) return 0;
  return exponent == 0 ? 1 : std::pow(std::max(cosine, 0.0f), exponent);
}

/// Towards `position` from `point`; scaled first, so that squares neither overflow nor vanish.
void aim(const glm::vec3& position, const glm::vec3& point, ArrivingLight& light) {
  const glm::dvec3 way = glm::dvec3(position) - glm::dvec3(point);
  const double distance = glm::length(way);
  light.distance = static_cast<float>(distance);
  if (distance > 0) light.direction = glm::vec3(way / distance);
}

/// GL 2.1, 2.14.1.
ArrivingLight arriving(const PreparedLight& l, const glm::vec3& point) {
  ArrivingLight light{l.position, kInfinite, l.diffuse, l.specular};
  float factor = 1;
  if (!l.directional) {
    aim(l.position, point, light);
    if (l.attenuated) factor *= attenuation(l.attenuation, light.distance);
    light.atViewer = l.position == glm::vec3(0);
  }
  if (l.spot) factor *= inCone(-glm::dot(light.direction, l.spotDirection), l.spotCosCutoff, l.spotExponent);
  light.color *= factor, light.specular *= factor;
  return light;
}

ArrivingLight arriving(const scene::FragmentLight& l, float coneCosine, const glm::vec3& point) {
  ArrivingLight light{-l.direction, kInfinite, l.color, l.color};
  light.atViewer = l.kind == scene::FragmentLight::headlight;
  if (l.kind != scene::FragmentLight::positional) return light;
  aim(l.position, point, light);
  light.color *= attenuation(l.attenuation, light.distance);
  if (l.coneAngle < 90)
    light.color *= inCone(-glm::dot(light.direction, l.direction), coneCosine, l.exponent);
  light.specular = light.color;
  return light;
}

}  // namespace

ShadingLights::ShadingLights(const FrameData& frame)
    : surfaces_(frame.surfaces), counts_(surfaces_.size()), lightingFromEye_(surfaces_.size(), glm::mat4(1)) {
  const size_t drawn = frame.snapshot->instances.size();
  for (size_t i = 0; i < surfaces_.size(); ++i) {
    const scene::Instance* instance = surfaces_[i].instance;
    if (!instance) continue;
    const Lighting& lighting = *surfaces_[i].lighting;
    const bool program = isProgram(surfaces_[i]);
    counts_[i] =
        static_cast<uint32_t>(program ? lighting.shading->fragment.lights.size() : lighting.lights.size());
    if (frame.relit && i < drawn)
      counts_[i] = static_cast<uint32_t>(frame.relit->firstSource[frame.shadingOf(i)]);
    if (program)
      lightingFromEye_[i] =
          glm::mat4(glm::inverse(eyeFromLighting(*instance, *lighting.shading, frame.eyeRays.step)));
  }
}

ArrivingLight ShadingLights::at(uint32_t instance, uint32_t index, const glm::vec3& point) const {
  const Lighting& lighting = *surfaces_[instance].lighting;
  if (!isProgram(surfaces_[instance])) return arriving(lighting.lights[index], point);
  const glm::mat4& lightingFromEye = lightingFromEye_[instance];
  const glm::vec3 there(lightingFromEye * glm::vec4(point, 1));
  ArrivingLight light =
      arriving(lighting.shading->fragment.lights[index], lighting.coneCosines[index], there);
  // A program's eye space is OpenGL's, but for a rotation or a scale.
  const glm::vec3 back = light.direction * glm::mat3(lightingFromEye);
  const float scale = glm::length(back);
  if (scale > 0) light.direction = back / scale, light.distance /= scale;
  return light;
}

glm::vec3 ShadingLights::highlight(uint32_t instance, uint32_t index, const ArrivingLight& light,
                                   const glm::vec3& normal, const glm::vec3& toViewer,
                                   float shininess) const {
  const scene::FragmentShading& f = surfaces_[instance].lighting->shading->fragment;
  const bool ahead =
      isProgram(surfaces_[instance]) && f.lights[index].kind == scene::FragmentLight::headlight;
  return light.specular * highlight(instance, ahead, light.direction, normal, toViewer, shininess);
}

float ShadingLights::highlight(uint32_t instance, const glm::vec3& direction, const glm::vec3& normal,
                               const glm::vec3& toViewer, float shininess) const {
  return highlight(instance, false, direction, normal, toViewer, shininess);
}

float ShadingLights::highlight(uint32_t instance, bool ahead, const glm::vec3& direction,
                               const glm::vec3& normal, const glm::vec3& toViewer, float shininess) const {
  const scene::FragmentShading& f = surfaces_[instance].lighting->shading->fragment;
  const float cosine = glm::dot(normal, direction);
  if (!(cosine > 0)) return 0;
  float base;
  if (isProgram(surfaces_[instance])) {
    if (f.model != scene::FragmentShading::Model::phong) return 0;
    if (ahead)
      base = cosine;
    else if (f.specular == scene::FragmentShading::Specular::half)
      base = glm::dot(normal, glm::normalize(toViewer + direction));
    else
      base = std::max(glm::dot(2 * cosine * normal - direction, toViewer), 1e-5f);
  } else {
    base = glm::dot(normal, glm::normalize(direction + toViewer));
  }
  return std::pow(std::clamp(base, 0.0f, 1.0f), shininess);
}

}  // namespace gluray::render
