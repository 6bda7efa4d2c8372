// The GLSL program of the write-back. GL thread, context current.
#pragma once
#include "base/image.h"
#include "intercept/present/state/features.h"

#include <string>

namespace gluray::present {

/// Compiles and links: GLSL 1.10 with positions from glVertex in compatibility contexts, GLSL 1.30 to 1.50
/// without any vertex attribute in core contexts. Returns the program's name, or 0 with the reason. Uniforms:
/// colorPlane and depthPlane (samplers), place = (window x, y of texel (0,0); texture coordinates of one
/// texel), and in core contexts bands[32] = corners (left, lower, right, upper) in clip space, six vertices
/// each. For sums, depthPlane is the transmittance.
GLuint buildWriteBackProgram(const gl::RealGl& real, const Features& features, bool sums, std::string& why);

}  // namespace gluray::present
