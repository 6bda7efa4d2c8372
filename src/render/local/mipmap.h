// Level of detail: which levels of a mipmapped texture a fragment sees. Called on tracing threads.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// How texture coordinates, in texels of the base level, change from a pixel to its neighbours.
struct Footprint {
  glm::dvec3 dx{0}, dy{0};
};

/// What of an image is sampled: `level` and, where `blend` > 0, that share of the level after it.
struct LevelChoice {
  bool magnified = false;  // the magnification filter holds, on level 0
  int level = 0;
  float blend = 0;
};

/// Whether the footprint can make a difference to the texture.
bool needsFootprint(const scene::Texture&);

/// GL 2.1, 3.8.8 and 3.8.9, by the texture's LodRule.
LevelChoice chooseLevel(const scene::Texture&, const Footprint&);

/// RGBA at normalised coordinates as sampleLevel() takes them.
glm::vec4 sampleTexture(const scene::Texture&, const Footprint&, glm::vec3 str);

}  // namespace gluray::render
