// Surfaces that are seen through, around the tracing of them: textures read and written, and the program's
// own passes where they cannot be traced. GL thread, context current; all state is put back.
#pragma once
#include "gl/programs/held_pass.h"
#include "gl/textures/texture_image.h"
#include "intercept/present/write_back/state_guard.h"

#include <cstdint>
#include <vector>

namespace gluray::present {

/// gl::LayerPresenter::readDepths.
bool readDepths(const gl::RealGl& real, const Features& features, GLint unit, glm::ivec2 size,
                std::vector<glm::vec2>& out);

/// Replaces level 0 of a texture. False where it is not RGBA8 of that size.
bool writeTexture(const gl::RealGl& real, const Features& features, GLuint texture, glm::ivec2 size,
                  const uint32_t* pixels);

/// Takes an earlier picture out of the result.
bool clearResult(const gl::RealGl& real, const Features& features, const gl::LayersTarget& target);

/// Puts the picture that waits into the newest peel's result; of what came after the first peel only clears
/// are made.
bool showPicture(const gl::RealGl& real, const Features& features, const gl::LayersTarget& target);

/// gl::LayerPresenter::countPixels.
bool countPixels(const gl::RealGl& real, const Features& features, const gl::HeldPass& pass, GLuint texture,
                 glm::ivec2 size, uint64_t pixels);

/// Makes all held passes by the real OpenGL. False where their framebuffers are not complete any more.
bool drawLayers(const gl::RealGl& real, const Features& features, const gl::LayersTarget& target);

}  // namespace gluray::present
