// What gluray-bench-objects draws: balls, and a shader program with three lights that paints them.
#pragma once
#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <array>
#include <vector>

namespace gluray::bench {

/// What one ball has for itself, as an array of instances stores it.
struct BallPlace {
  std::array<float, 3> center;
  float size;
  std::array<float, 3> paint;
};

/// Meshes of 2 * side * (side - 1) triangles, balls of radius 1 with waves. Attributes 0 and 1: position and
/// normal.
class Balls {
 public:
  static constexpr int kMeshes = 64;

  explicit Balls(int side);
  void draw(int mesh) const;
  /// One draw of a ball at each place, all of the first mesh. Attributes 2 and 3: centre with size, and
  /// paint.
  void drawInstances(const std::vector<BallPlace>& places);
  GLsizei triangles() const { return count_ / 3; }

 private:
  GLsizei count_;
  std::array<GLuint, kMeshes> arrays_{}, buffers_{};
  GLuint places_ = 0;
};

/// The program. Uniforms: mat4 clipFromWorld, vec3 viewer; unless `instanced` also mat4 worldFromObject and
/// vec3 paint. Throws std::runtime_error if it does not link.
GLuint makeBallProgram(bool instanced);

}  // namespace gluray::bench
