#include "render/shading/pbr_textures.h"

namespace gluray::render {

PbrTextures::PbrTextures(const Surface& surface, const scene::Camera& camera)
    : surface_(surface),
      pbr_(surface.lighting->shading->fragment.pbr),
      triangle_(surface, camera, pbr_.textures) {}

PbrTexels PbrTextures::at(uint32_t primitive, float u, float v, glm::dvec2 window, const WeightSteps* steps) {
  glm::vec4 texels[scene::kTextureUnits];
  triangle_.texels(primitive, u, v, window, steps, texels);
  PbrTexels out;
  if (pbr_.material >= 0) {
    const glm::vec4& material = texels[pbr_.material];
    out.occlusion = material.r, out.roughness = material.g, out.metallic = material.b;
  }
  if (pbr_.emission >= 0) out.emission = glm::vec3(texels[pbr_.emission]);
  if (pbr_.normal < 0) return out;
  const glm::vec3 normal = glm::vec3(texels[pbr_.normal]) * 2.0f - 1.0f;
  out.normal = glm::normalize(normal * glm::vec3(pbr_.normalScale, pbr_.normalScale, 1));
  constexpr uint32_t kUnit = scene::PbrSurface::kTangentUnit;
  const scene::Attribute* tangents = surface_.mesh->texcoordsOf(kUnit);
  if (!tangents) {
    out.tangent = glm::vec3(surface_.instance->texcoordOf(kUnit));
    return out;
  }
  const auto corner = [&](uint32_t k) {
    return glm::vec3(scene::fetch(*tangents, surface_.mesh->corner(primitive, k)));
  };
  out.tangent = (1 - u - v) * corner(0) + u * corner(1) + v * corner(2);
  return out;
}

glm::vec3 mappedNormal(const glm::vec3& normal, const glm::vec3& tangent, const glm::vec3& texel) {
  const glm::vec3 t = glm::normalize(tangent - glm::dot(tangent, normal) * normal);
  return glm::normalize(t * texel.x + glm::cross(normal, t) * texel.y + normal * texel.z);
}

}  // namespace gluray::render
