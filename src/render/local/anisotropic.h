// Anisotropic texture filtering as llvmpipe has it. Called by the kernels on tracing threads.
#pragma once
#include "render/local/mipmap.h"

namespace gluray::render {

/// RGBA of a two-dimensional texture at normalised coordinates: a Gaussian mean over the pixel's ellipse, on
/// the level where its shorter axis is about one texel. Source: P. Heckbert, "Fundamentals of Texture Mapping
/// and Image Warping", 1989, p. 59, with the weights, the enlarged ellipse and the roundings of Mesa's
/// llvmpipe.
glm::vec4 sampleAnisotropic(const scene::Texture&, const Footprint&, glm::vec3 str);

}  // namespace gluray::render
