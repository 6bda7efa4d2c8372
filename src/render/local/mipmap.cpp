#include "render/local/mipmap.h"

#include "render/local/anisotropic.h"
#include "render/local/byte_filter.h"
#include "render/local/texture_lookup.h"

#include <algorithm>
#include <cmath>

namespace gluray::render {
namespace {

using scene::Filter;
using scene::MipFilter;
using scene::Texture;

/// GL 2.1, equation 3.20.
double scaleFactor(const Footprint& f) { return std::max(glm::length(f.dx), glm::length(f.dy)); }

float clampLod(const Texture& t, float lod) {
  return std::max(std::min(lod, std::max(t.minLod, t.maxLod)), std::min(t.minLod, t.maxLod));
}

/// Clamps `level`, an integer of any size, to the image's levels.
LevelChoice within(const Texture& t, float level, float blend) {
  const int last = t.image->levels() - 1;
  if (level < 0) return {false, 0, 0};
  if (level >= static_cast<float>(last)) return {false, last, 0};
  return {false, static_cast<int>(level), blend};
}

LevelChoice chooseAsSpecified(const Texture& t, float lod) {
  const float lambda = clampLod(t, lod + t.lodBias);
  const bool sharp =
      t.magFilter == Filter::linear && t.minFilter == Filter::nearest && t.mipFilter != MipFilter::none;
  if (!(lambda > (sharp ? 0.5f : 0.0f))) return {true, 0, 0};
  if (t.mipFilter == MipFilter::none) return {};
  if (t.mipFilter == MipFilter::nearest) return within(t, std::ceil(lambda + 0.5f) - 1, 0);
  const float whole = std::floor(lambda);
  return within(t, whole, lambda - whole);
}

/// Differs from GL 2.1: interpolates the logarithm linearly between powers of two, and magnifies up to level
/// of detail 0, whatever the filters.
LevelChoice chooseAsLlvmpipe(const Texture& t, float straight) {
  const float lod = clampLod(t, straight + t.lodBias);
  if (!(lod > 0)) return {true, 0, 0};
  if (t.mipFilter == MipFilter::nearest) {
    // Rounds halves to even with a bias, up without.
    const float level = t.lodBias == 0 ? std::floor(lod + 0.5f) : std::nearbyint(lod);
    return within(t, level, 0);
  }
  const float whole = std::floor(lod);
  return within(t, whole, lod - whole);
}

}  // namespace

bool needsFootprint(const Texture& t) {
  return t.mipFilter != MipFilter::none || t.minFilter != t.magFilter || t.maxAnisotropy > 1;
}

float llvmpipeLod(double squaredScale) {
  int exponent = 0;
  const double mantissa = 2 * std::frexp(squaredScale, &exponent);  // in [1, 2)
  return static_cast<float>(0.5 * (exponent - 1 + (mantissa - 1)));
}

float limitedLod(const Texture& t, float lod) { return clampLod(t, lod + t.lodBias); }

LevelChoice chooseLevel(const Texture& t, const Footprint& footprint) {
  const double rho = scaleFactor(footprint);
  if (!std::isfinite(rho)) return {};
  if (t.lodRule != scene::LodRule::llvmpipe) return chooseAsSpecified(t, static_cast<float>(std::log2(rho)));
  if (t.mipFilter == MipFilter::none) return {!(rho > 1), 0, 0};
  return chooseAsLlvmpipe(t, llvmpipeLod(rho * rho));
}

namespace {

glm::vec4 sampleChosen(const Texture& t, const LevelChoice& choice, glm::vec3 str) {
  if (choice.magnified) return sampleLevel(t, *t.image, t.magFilter, str);
  const glm::vec4 color = sampleLevel(t, t.image->level(choice.level), t.minFilter, str);
  if (choice.blend <= 0) return color;
  const glm::vec4 next = sampleLevel(t, t.image->level(choice.level + 1), t.minFilter, str);
  return isFilteredInBytes(t) ? mixBytes(color, next, choice.blend) : glm::mix(color, next, choice.blend);
}

}  // namespace

glm::vec4 sampleTexture(const Texture& t, const Footprint& footprint, glm::vec3 str) {
  if (t.maxAnisotropy > 1) return sampleAnisotropic(t, footprint, str);
  if (!needsFootprint(t)) return sampleLevel(t, *t.image, t.magFilter, str);
  return sampleChosen(t, chooseLevel(t, footprint), str);
}

glm::vec4 sampleAtLod(const Texture& t, float lod, glm::vec3 str) {
  if (t.mipFilter == MipFilter::none) return sampleLevel(t, *t.image, t.magFilter, str);
  const bool llvmpipe = t.lodRule == scene::LodRule::llvmpipe;
  return sampleChosen(t, llvmpipe ? chooseAsLlvmpipe(t, lod) : chooseAsSpecified(t, lod), str);
}

}  // namespace gluray::render
