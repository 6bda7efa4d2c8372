// Filters of textures with eight bits per component as llvmpipe computes them: in eight bits. Called by the
// kernels on tracing threads.
#pragma once
#include "scene/texture.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// Whether the texture is filtered in eight bits: its sampling says so and it has texels of eight bits.
bool isFilteredInBytes(const scene::Texture&);

/// sampleLevel() with the linear filter: weights are multiples of 1/256, and each interpolation rounds to
/// eight bits. For wrap modes repeat and clampToEdge; cube maps are clamped to the edges of their faces.
glm::vec4 sampleBytes(const scene::Texture&, const scene::TexelGrid&, glm::vec3 str);

/// Interpolates the colours of two levels, which are multiples of 1/255.
glm::vec4 mixBytes(const glm::vec4& a, const glm::vec4& b, float weight);

}  // namespace gluray::render
