// Weighted blending as VTK 9.1's vtkOrderIndependentTranslucentPass does it: surfaces that are seen through
// are added up in textures of floats.
#pragma once
#include "tests/reference/layers/layer.h"

namespace gluray::test {

/// Draws what is opaque, adds up the rest, and puts it over.
class Summer {
 public:
  explicit Summer(Gl gl);
  std::function<void()> between;  // surfaces that are added up
  GLuint colors() const { return colors_; }
  GLuint opacities() const { return opacities_; }
  GLenum depthFunc = GL_LEQUAL;
  void frame(const std::vector<Layer>& all);

 private:
  Gl gl_;
  GLuint below_ = 0, sums_ = 0, colors_ = 0, opacities_ = 0, over_ = 0, none_ = 0;
};

}  // namespace gluray::test
