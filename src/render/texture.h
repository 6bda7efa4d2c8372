// Texturing of one fragment as OpenGL's fixed-function pipeline does it. Called by the kernels on tracing
// threads.
#pragma once
#include "render/surface.h"
#include "scene/texture.h"

#include <glm/glm.hpp>

namespace gluray::render {

/// RGBA of the image at normalised coordinates (s, t), by the given filter and the texture's wrap modes.
/// Source: GL 2.1, 3.8.7 to 3.8.9.
glm::vec4 sampleTexture(const scene::Texture&, scene::Filter, glm::vec2 st);

/// The fragment colour `primary` combined with `texel` by the texture's environment. GL 2.1, tables 3.22
/// and 3.23.
glm::vec4 applyEnvironment(const scene::Texture&, glm::vec4 texel, glm::vec4 primary);

/// Texture coordinates (s/q, t/q) at (primitive, u, v), through the texture matrix.
glm::vec2 textureCoordinates(const Surface&, const scene::Texture&, uint32_t primitive, float u, float v);

/// True if a pixel at window position (x, y) on the triangle covers more than one texel of the image:
/// GL 2.1, 3.8.8.
bool isMinified(const Surface&, const scene::Texture&, const WindowMap&, uint32_t primitive,
                glm::dvec2 window);

/// All of the above for every texture of the surface: the textured colour of a fragment.
glm::vec4 textureFragment(const Surface&, const WindowMap&, uint32_t primitive, float u, float v,
                          glm::dvec2 window, glm::vec4 primary);

}  // namespace gluray::render
