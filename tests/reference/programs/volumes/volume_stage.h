// A small ray caster of volumes and the family that describes it. For program_volume*_test.cpp.
#pragma once
#include "tests/reference/programs/program_stage.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace gluray::test {

/// Samples are the same: colours differ by roundings, and where rounding decides whether a pixel is covered
/// or which voxel is the nearest one.
inline constexpr scenes::Tolerance kVolumeTolerance = {
    2, 0.0005, 1e-5f, "silhouettes of the box, where surfaces cut it, samples between two nearest voxels"};

/// Text of the ray caster's fragment shader.
struct CasterText {
  std::string more;     // statements at the end of each step
  bool depths = false;  // rays end at a texture of depths
};
GLuint makeCaster(Gl gl, const CasterText& text = {});
/// The family of ray casters without further statements.
std::string casterFamily(bool depths = false);

/// A 3D texture of one component on unit 0.
struct VoxelImage {
  glm::ivec3 size{9, 7, 11};
  GLenum format = GL_R32F;
  GLint filter = GL_LINEAR, wrap = GL_CLAMP_TO_EDGE;
};
/// A smooth field from 0 to 1; signed formats have it from -1 to 1, their smallest numbers among them.
GLuint makeVoxels(Gl gl, const VoxelImage& image);
/// Replaces a part of the texture on unit 0 by one value.
void changeVoxels(Gl gl, const glm::ivec3& first, const glm::ivec3& size, float value);

/// The caster's box from -1 to 1 with tables on units 1 and 2.
class CastBox {
 public:
  explicit CastBox(Gl gl, GLuint program);
  /// Uses the program, sets uniforms and the state that volumes are traced with.
  void begin(Gl gl, const View& view, float scale = 1, float bias = 0) const;
  /// Draws the box.
  void draw(Gl gl) const;

 private:
  GLuint program_, array_ = 0;
};

}  // namespace gluray::test
