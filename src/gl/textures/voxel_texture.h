// Volumes, and the depths that end their rays, read back from textures of the real OpenGL. GL thread.
#pragma once
#include "gl/real/extensions.h"
#include "gl/real/real.h"
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

/// Level 0 of the texture bound to GL_TEXTURE_2D of the active unit. False if it holds no depths, or has
/// another size.
bool readDepthTexture(const RealGl& real, const RareState& has, glm::ivec2 size, std::vector<float>& out);

}  // namespace gluray::gl
