#include "render/integrators/occluder_alpha.h"

#include "render/local/mipmap.h"

#include <algorithm>

namespace gluray::render {
namespace {

/// Texture coordinates of a unit at the point, after the texture matrix.
glm::vec3 coordinatesAt(const Surface& s, const scene::Texture& texture, const accel::Occluder& o) {
  const scene::Attribute* const array = s.mesh->texcoordsOf(texture.unit);
  const auto corner = [&](uint32_t k) { return scene::fetch(*array, s.mesh->corner(o.primitive, k)); };
  const glm::vec4 given = array ? corner(0) * (1 - o.u - o.v) + corner(1) * o.u + corner(2) * o.v
                                : s.instance->texcoordOf(texture.unit);
  const glm::vec4 at = texture.textureMatrix * given;
  return glm::vec3(at) / at.w;
}

/// GL 2.1, tables 3.21 to 3.23: the alpha that the unit makes of `alpha`.
float textured(const scene::Texture& texture, float sampled, float alpha) {
  using scene::BaseFormat;
  using scene::TexEnv;
  const BaseFormat format = texture.image->baseFormat;
  if (format == BaseFormat::luminance || format == BaseFormat::rgb) return alpha;
  switch (texture.env) {
    case TexEnv::replace: return sampled;
    case TexEnv::decal: return alpha;
    case TexEnv::blend:
      if (format == BaseFormat::intensity) return glm::mix(alpha, texture.envColor.a, sampled);
      return alpha * sampled;
    case TexEnv::add:
      return format == BaseFormat::intensity ? std::min(alpha + sampled, 1.0f) : alpha * sampled;
    default: return alpha * sampled;
  }
}

}  // namespace

float fragmentAlpha(const Surface& s, const accel::Occluder& o, float primary) {
  float alpha = primary;
  if (s.mesh->shape != scene::Shape::triangles) return alpha;
  for (const scene::Texture& texture : s.lighting->shading->textures) {
    if (texture.image->opaque && texture.env != scene::TexEnv::replace) continue;
    if (texture.texGen.on() || texture.env == scene::TexEnv::combine) continue;
    alpha = textured(texture, sampleTexture(texture, {}, coordinatesAt(s, texture, o)).a, alpha);
  }
  return alpha;
}

}  // namespace gluray::render
