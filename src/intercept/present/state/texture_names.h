// Names of textures of our own. GL thread, context current.
#pragma once
#include "intercept/present/state/features.h"

#include <GL/gl.h>

#include <mutex>

namespace gluray::present {

/// Binding reserves a name: contexts of other threads may share the name space. To be held from
/// newTextureName() until the name is bound.
std::mutex& textureNaming();

/// A name that no texture has. Compatibility contexts let a program bind names that it never generated,
/// usually small ones. Ours come from the very end of the name space: Mesa generates names after the largest
/// one in use while any are left, and programs use names as array indices.
GLuint newTextureName(const gl::RealGl& real, const Features& features);

}  // namespace gluray::present
