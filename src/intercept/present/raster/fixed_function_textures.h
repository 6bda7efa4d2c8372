// Says to the real OpenGL's texture units what scene::Texture says. GL thread, used by the raster fallback
// between glPushAttrib and glPopAttrib.
#pragma once
#include "intercept/present/features.h"
#include "scene/texture.h"

#include <unordered_map>
#include <vector>

namespace gluray::present {

/// Textures made for one drawing, deleted at the end of it, and the texture matrices it changes.
class ShadingTextures {
 public:
  ShadingTextures(const gl::RealGl& real, const Features& features);
  ~ShadingTextures();
  ShadingTextures(const ShadingTextures&) = delete;
  ShadingTextures& operator=(const ShadingTextures&) = delete;
  /// Sets the units of `textures` and turns off all others. Unit 0 is active afterwards, the modelview matrix
  /// chosen; it must be the identity, because planes are given in eye space.
  void set(const std::vector<scene::Texture>& textures);

 private:
  void select(int unit);
  void turnOff(int unit);
  void keepMatrix(int unit);
  void bind(const scene::Texture&, GLenum target);

  const gl::RealGl& real_;
  const Features& features_;
  std::unordered_map<const scene::TextureImage*, GLuint> names_;
  std::vector<bool> on_;  // units, by what set() did last
  struct Matrix {
    int unit;
    GLdouble values[16];
  };
  std::vector<Matrix> matrices_;
};

}  // namespace gluray::present
