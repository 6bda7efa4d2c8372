// TextureCache: textures of volumes, and of the depths that end their rays.
#include "gl/textures/active_unit.h"
#include "gl/textures/texture_cache.h"
#include "gl/textures/texture_sampling.h"
#include "gl/textures/voxel_texture.h"

namespace gluray::gl {

std::shared_ptr<const scene::VoxelGrid> TextureCache::voxels(const RealGl& real, const RareState& has,
                                                             GLint unit, scene::Texture& sampling,
                                                             std::string& why) {
  forgetChanged();
  ActiveUnit active(real);
  active.select(static_cast<GLenum>(GL_TEXTURE0 + unit));
  why = "the sampling parameters of its texture are not traced";
  if (samplerOf(real) != 0) return nullptr;
  sampling.target = scene::TextureTarget::texture3D;
  if (readSampling(real, has, GL_TEXTURE_3D, sampling) != Reason::traced ||
      sampling.mipFilter != scene::MipFilter::none || sampling.magFilter != sampling.minFilter)
    return nullptr;
  GLint base = 0;
  real.GetTexParameteriv(GL_TEXTURE_3D, GL_TEXTURE_BASE_LEVEL, &base);
  if (base != 0) return nullptr;
  std::shared_ptr<const scene::VoxelGrid>& known =
      voxels_[static_cast<GLuint>(integer(real, GL_TEXTURE_BINDING_3D))];
  if (!known) known = readVoxels(real, has, why);
  return known;
}

bool TextureCache::depths(const RealGl& real, const RareState& has, GLint unit, DepthTexture& out) {
  ActiveUnit active(real);
  active.select(static_cast<GLenum>(GL_TEXTURE0 + unit));
  if (samplerOf(real) != 0) return false;
  return readDepthTexture(real, has, out);
}

}  // namespace gluray::gl
