// The GLSL program of the write-back. GL thread, context current.
#pragma once
#include "base/image.h"
#include "intercept/present/state/features.h"

#include <cstdint>
#include <string>

namespace gluray::present {

/// What the program takes pixels from.
enum class WriteBackSource : uint8_t {
  colors,  // colours and window depths
  sums,    // colours and transmittance, of sums
  taken    // opacities of black in one plane, of the textures' alpha or, in core contexts, red
};

/// Compiles and links: GLSL 1.10 with positions from glVertex in compatibility contexts, GLSL 1.30 to 1.50
/// without any vertex attribute in core contexts. Returns the program's name, or 0 with the reason. Uniforms:
/// colorPlane and depthPlane (samplers), place = (window x, y of texel (0,0); texture coordinates of one
/// texel), and in core contexts bands[32] = corners (left, lower, right, upper) in clip space, six vertices
/// each. For sums, depthPlane is the transmittance; for opacities it does not exist.
GLuint buildWriteBackProgram(const gl::RealGl& real, const Features& features, WriteBackSource source,
                             std::string& why);

}  // namespace gluray::present
