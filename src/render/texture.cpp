#include "render/texture.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::BaseFormat;
using scene::Wrap;

// The coordinate within the image after wrapping, GL 2.1, 3.8.7; `size` texels.
float wrapCoordinate(Wrap wrap, float s, int size) {
  if (!std::isfinite(s)) return 0;
  const float half = 0.5f / static_cast<float>(size);
  switch (wrap) {
    case Wrap::repeat: return s - std::floor(s);
    case Wrap::clamp: return std::clamp(s, 0.0f, 1.0f);
    case Wrap::clampToEdge: return std::clamp(s, half, 1 - half);
    case Wrap::clampToBorder: return std::clamp(s, -half, 1 + half);
    case Wrap::mirroredRepeat: {
      const float whole = std::floor(s), part = s - whole;
      const bool odd = std::fmod(whole, 2.0f) != 0;
      return std::clamp(odd ? 1 - part : part, half, 1 - half);
    }
  }
  return s;
}

// The border colour as a texel of the image's base format.
glm::vec4 borderTexel(const scene::Texture& t) {
  const glm::vec4 c = t.borderColor;
  switch (t.image->baseFormat) {
    case BaseFormat::alpha: return {0, 0, 0, c.a};
    case BaseFormat::luminance: return {c.r, c.r, c.r, 1};
    case BaseFormat::luminanceAlpha: return {c.r, c.r, c.r, c.a};
    case BaseFormat::intensity: return {c.r, c.r, c.r, c.r};
    case BaseFormat::rgb: return {c.r, c.g, c.b, 1};
    case BaseFormat::rgba: return c;
  }
  return c;
}

glm::vec4 texelAt(const scene::Texture& t, int i, int j) {
  const scene::TextureImage& image = *t.image;
  if (t.wrapS == Wrap::repeat) i = (i % image.width + image.width) % image.width;
  if (t.wrapT == Wrap::repeat || t.dimensions == 1) j = (j % image.height + image.height) % image.height;
  if (i < 0 || j < 0 || i >= image.width || j >= image.height) return borderTexel(t);
  const uint32_t c =
      image.texels[static_cast<size_t>(j) * static_cast<size_t>(image.width) + static_cast<size_t>(i)];
  return glm::vec4(c & 255, c >> 8 & 255, c >> 16 & 255, c >> 24) * (1.0f / 255.0f);
}

int nearestTexel(Wrap wrap, float u, int size) {
  const int i = static_cast<int>(std::floor(u));
  return wrap == Wrap::clamp ? std::clamp(i, 0, size - 1) : i;
}

}  // namespace

glm::vec4 sampleTexture(const scene::Texture& t, scene::Filter filter, glm::vec2 st) {
  const scene::TextureImage& image = *t.image;
  const bool oneDimensional = t.dimensions == 1;
  const float u = wrapCoordinate(t.wrapS, st.x, image.width) * static_cast<float>(image.width);
  const float v =
      oneDimensional ? 0.5f : wrapCoordinate(t.wrapT, st.y, image.height) * static_cast<float>(image.height);
  if (filter == scene::Filter::nearest) {
    return texelAt(t, nearestTexel(t.wrapS, u, image.width), nearestTexel(t.wrapT, v, image.height));
  }
  const float i = std::floor(u - 0.5f), j = std::floor(v - 0.5f);
  const float a = u - 0.5f - i, b = v - 0.5f - j;
  const int i0 = static_cast<int>(i), j0 = static_cast<int>(j);
  const glm::vec4 below = glm::mix(texelAt(t, i0, j0), texelAt(t, i0 + 1, j0), a);
  if (oneDimensional) return below;
  return glm::mix(below, glm::mix(texelAt(t, i0, j0 + 1), texelAt(t, i0 + 1, j0 + 1), a), b);
}

glm::vec4 applyEnvironment(const scene::Texture& t, glm::vec4 texel, glm::vec4 primary) {
  using scene::TexEnv;
  const BaseFormat format = t.image->baseFormat;
  const bool hasColor = format != BaseFormat::alpha;
  const bool hasAlpha = format != BaseFormat::luminance && format != BaseFormat::rgb;
  const bool intensity = format == BaseFormat::intensity;
  const glm::vec3 cf(primary), cs(texel), cc(t.envColor);
  const float af = primary.a, as = texel.a;
  // Alpha of modulate, blend and add, where no row of the tables says otherwise.
  const float modulated = hasAlpha ? af * as : af;
  switch (t.env) {
    case TexEnv::modulate: return {hasColor ? cf * cs : cf, modulated};
    case TexEnv::replace: return {hasColor ? cs : cf, hasAlpha ? as : af};
    case TexEnv::decal: return {hasAlpha ? glm::mix(cf, cs, as) : cs, af};
    case TexEnv::blend:
      return {hasColor ? cf * (1.0f - cs) + cc * cs : cf,
              intensity ? af * (1 - as) + t.envColor.a * as : modulated};
    case TexEnv::add: return {hasColor ? cf + cs : cf, intensity ? af + as : modulated};
  }
  return primary;
}

namespace {

glm::vec4 cornerCoordinates(const Surface& surface, uint32_t primitive, uint32_t k) {
  const scene::Attribute& texcoords = surface.mesh->texcoords;
  return texcoords ? scene::fetch(texcoords, surface.mesh->corner(primitive, k)) : surface.instance->texcoord;
}

glm::dvec2 coordinatesAt(const Surface& surface, const scene::Texture& t, uint32_t primitive,
                         const glm::dvec3& weight) {
  glm::dvec4 sum(0);
  for (uint32_t k = 0; k < 3; ++k) {
    sum += weight[static_cast<int>(k)] * glm::dvec4(cornerCoordinates(surface, primitive, k));
  }
  const glm::dvec4 strq = glm::dmat4(t.textureMatrix) * sum;
  return {strq.x / strq.w, strq.y / strq.w};
}

}  // namespace

glm::vec2 textureCoordinates(const Surface& surface, const scene::Texture& t, uint32_t primitive, float u,
                             float v) {
  return coordinatesAt(surface, t, primitive, {1.0 - u - v, u, v});
}

bool isMinified(const Surface& surface, const scene::Texture& t, const WindowMap& map, uint32_t primitive,
                glm::dvec2 window) {
  glm::dvec3 corner[3];  // clip x, y, w
  for (uint32_t k = 0; k < 3; ++k) {
    const glm::vec3 p = surface.mesh->position(surface.mesh->corner(primitive, k));
    const glm::dvec4 clip = surface.clipFromObject * glm::dvec4(p, 1.0);
    corner[k] = {clip.x, clip.y, clip.w};
  }
  // Perspective-correct weights of the corners at a window position are the edge functions there.
  const glm::dmat3 edges(glm::cross(corner[1], corner[2]), glm::cross(corner[2], corner[0]),
                         glm::cross(corner[0], corner[1]));
  const auto texel = [&](glm::dvec2 at) {
    const glm::dvec3 weight = glm::dvec3(map.ndcScale * at + map.ndcOffset, 1.0) * edges;
    const glm::dvec2 st = coordinatesAt(surface, t, primitive, weight / (weight.x + weight.y + weight.z));
    return st * glm::dvec2(t.image->width, t.dimensions == 1 ? 0 : t.image->height);
  };
  constexpr double kStep = 1.0 / 16;  // pixels
  const glm::dvec2 here = texel(window);
  const glm::dvec2 dx = (texel(window + glm::dvec2(kStep, 0)) - here) / kStep;
  const glm::dvec2 dy = (texel(window + glm::dvec2(0, kStep)) - here) / kStep;
  return std::max(glm::length(dx), glm::length(dy)) > 1.0;
}

glm::vec4 textureFragment(const Surface& surface, const WindowMap& map, uint32_t primitive, float u, float v,
                          glm::dvec2 window, glm::vec4 primary) {
  glm::vec4 color = primary;
  for (const scene::Texture& t : surface.lighting->shading->textures) {
    scene::Filter filter = t.magFilter;
    if (t.minFilter != t.magFilter && isMinified(surface, t, map, primitive, window)) filter = t.minFilter;
    const glm::vec4 texel = sampleTexture(t, filter, textureCoordinates(surface, t, primitive, u, v));
    color = glm::clamp(applyEnvironment(t, texel, color), 0.0f, 1.0f);
  }
  return color;
}

}  // namespace gluray::render
