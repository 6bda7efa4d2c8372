// Volumes, and the depths that end their rays, read back from textures of the real OpenGL. GL thread.
#pragma once
#include "gl/real/extensions.h"
#include "gl/real/real.h"
#include "scene/region.h"
#include "scene/volumes/voxel_grid.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace gluray::gl {

/// Level 0 of the texture bound to GL_TEXTURE_3D of the active unit, as it is stored. Null, with the reason
/// in `why`, if its format is not traced. Throws std::bad_alloc.
std::shared_ptr<const scene::VoxelGrid> readVoxels(const RealGl& real, const RareState& has,
                                                   std::string& why);

/// Level 0 of a texture of depths.
struct DepthTexture {
  glm::ivec2 size{0};
  std::vector<float> values;  // row by row
  bool linear = false;        // filter; false: the nearest texel
  /// At the centres of the pixels of `region`, row by row. Texture coordinates are those of a pixel's centre
  /// less `origin`, times `texel`, and clamped to the edge.
  std::vector<float> inRegion(const scene::Region& region, glm::vec2 origin, glm::vec2 texel) const;
};

/// The texture bound to GL_TEXTURE_2D of the active unit. False if it holds no depths, or is compared or
/// filtered in another way.
bool readDepthTexture(const RealGl& real, const RareState& has, DepthTexture& out);

}  // namespace gluray::gl
