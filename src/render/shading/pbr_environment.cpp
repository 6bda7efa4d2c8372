#include "render/shading/pbr_environment.h"

#include "render/local/mipmap.h"
#include "render/local/texture_lookup.h"

#include <algorithm>

namespace gluray::render {
namespace {

/// The cube map's coordinates for sampleLevel() in this direction.
glm::vec3 inCube(const glm::vec3& direction) {
  const int face = cubeFace(direction);
  return {glm::vec2(coordinatesInFace(face, direction)), static_cast<float>(face)};
}

/// Real spherical harmonics up to the second band, with VTK's signs and factors.
float harmonic(const std::array<float, 9>& sh, const glm::vec3& n) {
  const float v = sh[0] + sh[1] * n.y + sh[2] * n.z + sh[3] * n.x + sh[4] * n.x * n.y + sh[5] * n.y * n.z +
                  sh[6] * (3 * n.z * n.z - 1) + sh[7] * n.x * n.z + sh[8] * (n.x * n.x - n.y * n.y);
  return std::max(v, 0.0f);
}

}  // namespace

glm::vec3 irradianceOf(const scene::PbrEnvironment& e, const glm::vec3& normal) {
  const glm::vec3 n = e.worldFromEye * normal;
  if (e.byHarmonics)
    return {harmonic(e.harmonics[0], n), harmonic(e.harmonics[1], n), harmonic(e.harmonics[2], n)};
  const scene::Texture& t = e.irradiance.front();
  return glm::vec3(sampleLevel(t, *t.image, t.magFilter, inCube(n)));
}

glm::vec3 prefilteredFrom(const scene::PbrEnvironment& e, const glm::vec3& way, float roughness) {
  const scene::Texture& t = e.prefiltered.front();
  return glm::vec3(sampleAtLod(t, roughness * e.maxLevel, inCube(e.worldFromEye * way)));
}

glm::vec2 reflectedShares(const scene::PbrEnvironment& e, float cosine, float roughness) {
  const scene::Texture& t = e.brdf.front();
  return glm::vec2(sampleLevel(t, *t.image, t.magFilter, {cosine, roughness, 0}));
}

}  // namespace gluray::render
