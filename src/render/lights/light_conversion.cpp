#include "render/lights/light_conversion.h"

#include <cmath>

namespace gluray::render {
namespace {

using scene::LightSource;
using Kind = LightSource::Kind;

constexpr float kDegreesPerRadian = 57.29577951308232f;

glm::vec3 unitVector(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? glm::vec3(v / length) : glm::vec3(0);
}

/// How many times longer lengths become.
double stretch(const glm::dmat4& m) { return std::cbrt(std::abs(glm::determinant(glm::dmat3(m)))); }

/// What a light of fixed function or of a program has: areas as points.
struct PointLight {
  glm::vec3 attenuation{1, 0, 0};
  float coneAngle = 180, exponent = 0;  // degrees from the axis
};

/// The square of the radius of the disc that is as large as the area.
float squaredRadius(const LightSource& s) {
  if (s.kind != Kind::rectangle) return s.radius * s.radius;
  return 4 * glm::length(glm::cross(s.halfEdge[0], s.halfEdge[1])) / 3.14159265f;
}

/// A disc of radius R is seen as R^2 / (R^2 + d^2) of the sky's cosine-weighted share from a facing patch at
/// distance d on its axis, and a sphere as R^2 / d^2.
PointLight pointOf(const LightSource& s) {
  switch (s.kind) {
    case Kind::sphere: return {{0, 0, 1 / squaredRadius(s)}};
    case Kind::disc:
    case Kind::rectangle: return {{1, 0, 1 / squaredRadius(s)}, 89.99f, 1};
    case Kind::spot: return {s.attenuation, std::acos(s.coneCosine) * kDegreesPerRadian, s.coneExponent};
    default: return {s.attenuation};
  }
}

}  // namespace

LightSource sourceOf(const scene::Light& light) {
  LightSource s;
  s.color = glm::vec3(light.diffuse);
  if (light.position.w == 0) {
    s.direction = -unitVector(glm::dvec3(light.position));
    return s;
  }
  s.kind = Kind::point;
  s.position = glm::vec3(light.position) / light.position.w;
  s.attenuation = light.attenuation;
  if (light.spotCutoff == 180) return s;
  s.kind = Kind::spot;
  s.direction = unitVector(glm::dvec3(light.spotDirection));
  s.coneCosine = std::cos(light.spotCutoff / kDegreesPerRadian);
  s.coneExponent = light.spotExponent;
  return s;
}

LightSource sourceOf(const scene::FragmentLight& light, const glm::dmat4& eyeFromLighting) {
  LightSource s;
  s.color = light.color;
  s.direction = unitVector(glm::dmat3(eyeFromLighting) * glm::dvec3(light.direction));
  if (light.kind != scene::FragmentLight::positional) return s;
  s.kind = Kind::point;
  s.position = glm::vec3(eyeFromLighting * glm::dvec4(light.position, 1));
  const double longer = stretch(eyeFromLighting);
  s.attenuation = glm::vec3(glm::dvec3(light.attenuation) / glm::dvec3(1, longer, longer * longer));
  if (!(light.coneAngle < 90)) return s;
  s.kind = Kind::spot;
  s.coneCosine = std::cos(light.coneAngle / kDegreesPerRadian);
  s.coneExponent = light.exponent;
  return s;
}

scene::Light fixedLight(const LightSource& s) {
  scene::Light light;
  light.diffuse = light.specular = glm::vec4(s.color * s.strength, 1);
  if (s.kind == Kind::distant) {
    light.position = glm::vec4(-s.direction, 0);
    return light;
  }
  const PointLight point = pointOf(s);
  light.position = glm::vec4(s.position, 1);
  light.attenuation = point.attenuation;
  if (point.coneAngle < 180) light.spotDirection = s.direction;
  light.spotCutoff = point.coneAngle <= 90 ? point.coneAngle : 180;
  light.spotExponent = point.exponent;
  return light;
}

scene::FragmentLight programLight(const LightSource& s, const glm::dmat4& lightingFromEye) {
  scene::FragmentLight light;
  light.color = s.color * s.strength;
  light.direction = unitVector(glm::dmat3(lightingFromEye) * glm::dvec3(s.direction));
  light.kind = scene::FragmentLight::directional;
  if (s.kind == Kind::distant) return light;
  const PointLight point = pointOf(s);
  const double longer = stretch(lightingFromEye);
  light.kind = scene::FragmentLight::positional;
  light.position = glm::vec3(lightingFromEye * glm::dvec4(s.position, 1));
  light.attenuation = glm::vec3(glm::dvec3(point.attenuation) / glm::dvec3(1, longer, longer * longer));
  light.coneAngle = point.coneAngle;
  light.exponent = point.exponent;
  return light;
}

scene::LightSource headlightOf(float strength, const glm::dvec4& away) {
  scene::LightSource light;
  light.strength = strength;
  light.direction = glm::vec3(glm::normalize(glm::dvec3(away)));
  if (away.w == 0) return light;
  light.kind = scene::LightSource::Kind::point;
  light.position = glm::vec3(glm::dvec3(away) / away.w);
  return light;
}

}  // namespace gluray::render
