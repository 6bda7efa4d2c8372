// OpenGL operations around the tracing of layers: reads and writes textures, and draws the program's own
// passes if they cannot be traced. GL thread, context current; restores all state.
#pragma once
#include "gl/batch/held_pass.h"
#include "gl/textures/texture_image.h"
#include "intercept/present/state/state_guard.h"

#include <cstdint>
#include <vector>

namespace gluray::present {

/// gl::LayerPresenter::readDepths.
bool readDepths(const gl::RealGl& real, const Features& features, GLint unit, glm::ivec2 size,
                std::vector<glm::vec2>& out);

/// Replaces level 0 of a texture. False if it is not RGBA8 of that size.
bool writeTexture(const gl::RealGl& real, const Features& features, GLuint texture, glm::ivec2 size,
                  const uint32_t* pixels);

/// Clears an earlier image from the result.
bool clearResult(const gl::RealGl& real, const Features& features, const gl::LayersTarget& target);

/// Writes the pending image into the newest peel's result; of the passes after the first peel, performs
/// only clears.
bool showImage(const gl::RealGl& real, const Features& features, const gl::LayersTarget& target);

/// gl::LayerPresenter::countPixels.
bool countPixels(const gl::RealGl& real, const Features& features, const gl::HeldPass& pass, GLuint texture,
                 glm::ivec2 size, uint64_t pixels);

/// Draws all held passes with the real OpenGL. False if their framebuffers are no longer complete.
bool drawLayers(const gl::RealGl& real, const Features& features, const gl::LayersTarget& target);

}  // namespace gluray::present
