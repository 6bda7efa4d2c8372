// Level of detail: selects the levels of a mipmapped texture for a fragment. Called on tracing threads.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// Change of the texture coordinates, in texels of the base level, per pixel in x and y.
struct Footprint {
  glm::dvec3 dx{0}, dy{0};
};

/// The levels to sample: `level` and, if `blend` > 0, the next one with that weight.
struct LevelChoice {
  bool magnified = false;  // use the magnification filter, on level 0
  int level = 0;
  float blend = 0;
};

/// Whether the texture's sampling depends on the footprint.
bool needsFootprint(const scene::Texture&);

/// Chooses the levels: GL 2.1, 3.8.8 and 3.8.9, by the texture's LodRule.
LevelChoice chooseLevel(const scene::Texture&, const Footprint&);

/// The level of detail for a squared scale factor by llvmpipe's approximate logarithm, without bias and
/// limits.
float llvmpipeLod(double squaredScale);
/// The level of detail with the texture's bias and limits.
float limitedLod(const scene::Texture&, float lod);

/// RGBA at normalised coordinates, in the form of sampleLevel().
glm::vec4 sampleTexture(const scene::Texture&, const Footprint&, glm::vec3 str);

/// The same at an explicit level of detail, to which bias and limits apply (textureLod of GLSL).
glm::vec4 sampleAtLod(const scene::Texture&, float lod, glm::vec3 str);

}  // namespace gluray::render
