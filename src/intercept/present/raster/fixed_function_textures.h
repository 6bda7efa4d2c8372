// Sets the real OpenGL's texture units from scene::Texture. GL thread, used by the raster fallback between
// glPushAttrib and glPopAttrib.
#pragma once
#include "intercept/present/state/features.h"
#include "scene/texture.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace gluray::present {

/// Owns textures made for one drawing; the destructor deletes them and restores texture matrices.
class ShadingTextures {
 public:
  ShadingTextures(const gl::RealGl& real, const Features& features);
  ~ShadingTextures();
  ShadingTextures(const ShadingTextures&) = delete;
  ShadingTextures& operator=(const ShadingTextures&) = delete;
  /// Sets the units of `textures` and disables all others. Afterwards unit 0 is active, and the matrix mode
  /// is GL_MODELVIEW. Requires an identity modelview matrix, because planes are in eye space.
  void set(const std::vector<scene::Texture>& textures);

 private:
  void select(int unit);
  void turnOff(int unit);
  void keepMatrix(int unit);
  void bind(const scene::Texture&, GLenum target);
  void setSeamless(bool on);

  const gl::RealGl& real_;
  const Features& features_;
  std::unordered_map<const scene::TextureImage*, GLuint> names_;
  std::vector<bool> on_;                // units that the last set() enabled
  bool anisotropic_ = false;            // some texture has an anisotropic filter
  std::optional<bool> seamlessBefore_;  // GL_TEXTURE_CUBE_MAP_SEAMLESS, once it has been set
  struct Matrix {
    int unit;
    GLdouble values[16];
  };
  std::vector<Matrix> matrices_;
};

}  // namespace gluray::present
