#include "render/lights/rig.h"

#include "scene/upward_axis.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::LightSource;

LightSource distant(const glm::vec3& towards, float strength, float angle = 0) {
  LightSource light;
  light.direction = -towards;
  light.strength = strength;
  light.angle = angle;
  return light;
}

/// Strength of a light that, with another of a share of it at this cosine to it, lights the surface that
/// faces between them by 1.
float strongest(float share, float cosine) {
  return 1 / std::sqrt(1 + share * share + 2 * share * std::max(cosine, 0.0f));
}

bool onCamera(const Settings::Lights& s) {
  if (s.attached == LightsAttached::automatic) return s.rig != LightRig::sun && s.rig != LightRig::sky;
  return s.attached == LightsAttached::camera;
}

}  // namespace

glm::vec3 Directions::towards(double azimuth, double elevation) const {
  const double a = glm::radians(azimuth), e = glm::radians(elevation);
  return glm::vec3(std::sin(e) * up + std::cos(e) * (std::cos(a) * front + std::sin(a) * right));
}

glm::dvec2 Directions::anglesOf(const glm::dvec3& direction) const {
  const glm::dvec3 d = glm::normalize(direction);
  const auto plain = [](double degrees) { return std::abs(degrees) < 1e-9 ? 0 : degrees; };  // rounding
  return {plain(glm::degrees(std::atan2(glm::dot(d, right), glm::dot(d, front)))),
          plain(glm::degrees(std::asin(std::clamp(glm::dot(d, up), -1.0, 1.0))))};
}

Directions sceneDirections(const glm::dmat4& eyeFromWorld, int upAxis) {
  const auto axis = [&](int i) { return glm::normalize(glm::dvec3(eyeFromWorld[i % 3])); };
  const auto across = [](const glm::dvec3& v, const glm::dvec3& n) {
    return glm::normalize(v - n * glm::dot(v, n));
  };
  Directions d;
  d.up = axis(upAxis);
  d.front = across(axis(upAxis + 1), d.up);
  d.right = across(across(axis(upAxis + 2), d.up), d.front);
  return d;
}

Directions cameraDirections(const RaySetup& eyeRays, const glm::ivec4& viewport) {
  const double x = viewport.x + 0.5 * viewport.z, y = viewport.y + 0.5 * viewport.w;
  const glm::dvec4 middle = eyeRays.start + x * eyeRays.startX + y * eyeRays.startY;
  const glm::dvec3 at = glm::dvec3(middle) / middle.w;
  const auto along = [&](const glm::dvec4& step) {
    return glm::normalize((glm::dvec3(step) - at * step.w) / middle.w);
  };
  Directions d;
  d.up = along(eyeRays.startY);
  d.front = glm::normalize(glm::cross(along(eyeRays.startX), d.up));
  if (glm::dot(d.front, along(eyeRays.step)) > 0) d.front = -d.front;
  const glm::dvec3 right = glm::cross(d.up, d.front);
  d.right = glm::dot(right, along(eyeRays.startX)) < 0 ? -right : right;
  return d;
}

Directions rigDirections(const Settings& settings, const glm::dmat4& eyeFromWorld, const Directions& camera) {
  const Settings::Lights& s = settings.lights;
  return onCamera(s) ? camera : sceneDirections(eyeFromWorld, scene::upwardAxis(settings));
}

std::optional<Rig> makeRig(const Settings& settings, const glm::dmat4& eyeFromWorld,
                           const Directions& camera) {
  constexpr float kSun = 0.53f;  // degrees
  const Settings::Lights& s = settings.lights;
  if (s.rig == LightRig::program) return {};
  const Directions d = rigDirections(settings, eyeFromWorld, camera);
  const glm::vec3 key = d.towards(s.azimuth, s.elevation);
  const float share = 1 / s.ratio;
  Rig rig;
  rig.dome.up = glm::vec3(d.up);
  if (s.rig == LightRig::headlightAndKey || s.rig == LightRig::programAndKey) {
    // As if the scene were seen from its front: brightness stays the same while the camera moves.
    const float strength = s.strength * strongest(share, glm::dot(key, glm::vec3(d.front)));
    rig.lights = {distant(key, strength)};
    (s.rig == LightRig::headlightAndKey ? rig.headlight : rig.program) = strength * share;
  } else if (s.rig == LightRig::threePoint) {
    const glm::vec3 fill = d.towards(s.azimuth - 90.0, s.elevation / 3.0),
                    behind = d.towards(s.azimuth + 180.0, s.elevation);
    const float strength = s.strength * strongest(share, glm::dot(key, fill));
    rig.lights = {distant(key, strength), distant(fill, strength * share), distant(behind, strength / 2)};
  } else if (s.rig == LightRig::sun) {
    const float strength = s.strength / (1 + share);
    rig.lights = {distant(key, strength, kSun)};
    rig.dome.sky = glm::vec3(strength * share);
    rig.dome.ground = rig.dome.sky * 0.5f;
  } else {
    rig.dome.sky = glm::vec3(s.strength);
    rig.dome.ground = rig.dome.sky * 0.4f;
  }
  return rig;
}

}  // namespace gluray::render
