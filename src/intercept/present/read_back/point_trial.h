// Finds out by drawing where fragment programs see points (gl_PointCoord) in multisampled framebuffers. GL
// thread, context current; restores all state.
#pragma once
#include "gl/real/real.h"
#include "intercept/present/state/features.h"

#include <glm/glm.hpp>

#include <optional>

namespace gluray::present {

/// FramebufferReader::pointCoordinateShift().
std::optional<glm::vec2> tryPointCoordinates(const gl::RealGl& real, const Features& features, int samples);

}  // namespace gluray::present
