// Weighted blending as in VTK 9.1's vtkOrderIndependentTranslucentPass: translucent surfaces are summed
// in textures of floats.
#pragma once
#include "tests/reference/layers/layer.h"

namespace gluray::test {

/// Draws the opaque surfaces, sums the others, and composites the sum over them.
class Summer {
 public:
  explicit Summer(Gl gl);
  std::function<void()> between;  // called between summed surfaces
  std::function<void()> last;     // draws more to be summed
  GLuint colors() const { return colors_; }
  GLuint opacities() const { return opacities_; }
  GLenum depthFunc = GL_LEQUAL;
  void frame(const std::vector<Layer>& all);

 private:
  Gl gl_;
  GLuint below_ = 0, sums_ = 0, colors_ = 0, opacities_ = 0, over_ = 0, none_ = 0;
};

}  // namespace gluray::test
