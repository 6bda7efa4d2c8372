// Shader programs that draw points as VTK's Point Gaussian does: splats as since VTK 9.4, discs on triangles
// as before, in the looks that VTK and ParaView give them.
#pragma once
#include "tests/reference/programs/impostors/own_impostors.h"

#include <string>

namespace gluray::test {

struct PointGaussian {
  enum class Look {
    round,
    gaussian,
    sprite,
    outline
  };  // the last two: f3d's spheres and circles, of instances
  Look look = Look::gaussian;
  bool splats = true;      // otherwise discs
  bool instances = false;  // of strips of four vertices, in place of points
  bool oneColor = false;   // uniforms in place of an attribute
  bool fromZero = false;   // colours below 0 become 0
  bool sums = false;       // for order-independent blending
};
std::string vertexText(const PointGaussian& points);
std::string geometryText(const PointGaussian& points);
std::string fragmentText(const PointGaussian& points);

/// How they are drawn.
struct PointGaussianView {
  bool parallel = false;
  glm::vec3 stretch{1};  // scale of object space
  float radius = 0.25f, field = 40, offset = 0, lowpass = 0, bounds = 2, opacity = 1;
  float ambient = 0.1f;  // intensity of ambient light
  float alpha = 1;       // of the attribute's colours
  float blue = 0.3f;     // of these
  bool flat = false;     // all centres in one plane that faces the viewer
};
/// Makes the program and a vertex array current, and sets everything but the framebuffer.
void preparePointGaussian(Gl gl, GLuint program, const PointGaussian& points, const PointGaussianView& view);
/// Makes the draw.
void drawPrepared(Gl gl, const PointGaussian& points);
/// Clears the framebuffer and draws `kImpostors` of them.
void drawPointGaussian(Gl gl, const PointGaussian& points, const PointGaussianView& view);

}  // namespace gluray::test
