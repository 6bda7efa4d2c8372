// The GLSL program of the write-back. GL thread, context current.
#pragma once
#include "intercept/present/features.h"

#include <string>

namespace gluray::present {

/// Compiles and links for the context's GLSL version: 1.10 with fixed-function vertices in compatibility
/// contexts below GLSL 1.30, texel fetches above, generated vertices in core contexts. Returns the program's
/// name, or 0 with the reason. Uniforms: colorPlane and depthPlane (samplers), place = (window x, y of texel
/// (0,0); texture coordinates of one texel).
GLuint buildWriteBackProgram(const gl::RealGl& real, const Features& features, std::string& why);

}  // namespace gluray::present
