// Surfaces that are seen through, drawn by VTK's programs, for the tests of every way to composite them.
#pragma once
#include "tests/reference/programs/program_stage.h"

#include <functional>
#include <initializer_list>
#include <vector>

namespace gluray::test {

/// A surface: seen through unless its opacity is 1.
struct Layer {
  ProgramMesh mesh;
  Surface surface;
  glm::vec3 color{1};
  float opacity = 0.5f;
  GLenum mode = GL_TRIANGLES;
  View view = perspectiveView(20);
  std::function<void(Gl, GLuint program)> before = {};  // called before each of its draws
};

/// A view with the object moved and scaled.
View placed(const glm::dvec3& at, double size = 1);
Layer seen(ProgramMesh mesh, const glm::vec3& color, float opacity, const View& view);
/// A ball in a ball in a ball, and something opaque that cuts through them.
std::vector<Layer> balls();

/// Draws `layer`, which `uploaded` holds, by `program`. `more` sets uniforms of its own.
void drawLayer(Gl gl, GLuint program, const Upload& uploaded, const Layer& layer,
               const std::function<void()>& more = {});
/// The same with a mesh that is uploaded for this draw alone.
void drawFresh(Gl gl, GLuint program, const Layer& layer);

/// A texture of the window's size without filtering, and a framebuffer object of such and a depth buffer,
/// bound.
GLuint pictureTexture(Gl gl, GLenum internalFormat);
GLuint pictureFramebuffer(Gl gl, std::initializer_list<GLuint> colors);
/// The colours of the framebuffer that is bound for reading, in the window, which is bound then.
void showInWindow(Gl gl);

}  // namespace gluray::test
