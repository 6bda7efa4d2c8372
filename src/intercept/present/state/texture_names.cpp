#include "intercept/present/state/texture_names.h"

namespace gluray::present {

std::mutex& textureNaming() {
  static std::mutex naming;
  return naming;
}

GLuint newTextureName(const gl::RealGl& real, const Features& features) {
  GLuint name = 0;
  if (!features.compatibility) {
    real.GenTextures(1, &name);
    return name;
  }
  for (name = 0xFFFFFFFEu; real.IsTexture(name);) --name;
  return name;
}

}  // namespace gluray::present
