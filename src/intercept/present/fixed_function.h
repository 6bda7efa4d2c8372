// Says to the real OpenGL's fixed function what scene::Shading and scene::Instance say. GL thread, used by
// the raster fallback between glPushAttrib and glPopAttrib.
#pragma once
#include "intercept/present/features.h"
#include "scene/snapshot.h"

#include <unordered_map>

namespace gluray::present {

/// Textures made for one drawing, deleted at the end of it.
class ShadingTextures {
 public:
  explicit ShadingTextures(const gl::RealGl& real) : real_(real) {}
  ~ShadingTextures();
  ShadingTextures(const ShadingTextures&) = delete;
  ShadingTextures& operator=(const ShadingTextures&) = delete;
  /// Binds the texture's image to its target of the active unit and sets how it is sampled.
  void bind(const scene::Texture& texture);

 private:
  const gl::RealGl& real_;
  std::unordered_map<const scene::TextureImage*, GLuint> names_;
};

/// Everything a snapshot never holds is off: fog, texture generation, further texture units, colour sum,
/// programs.
void neutralFixedFunction(const gl::RealGl& real, const Features& features);
/// Lighting, lights, normalisation, shade model, texture.
void setShading(const gl::RealGl& real, const Features& features, const scene::Shading& shading,
                ShadingTextures& textures);
/// Modelview matrix, clip planes, culling, first material.
void setInstanceState(const gl::RealGl& real, const scene::Instance& instance);
/// May be called between glBegin and glEnd.
void setMaterials(const gl::RealGl& real, const scene::MaterialPair& materials);

}  // namespace gluray::present
