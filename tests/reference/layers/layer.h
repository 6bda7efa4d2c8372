// Translucent surfaces drawn by VTK's programs, for the tests of all compositing methods.
#pragma once
#include "tests/reference/programs/program_stage.h"

#include <functional>
#include <initializer_list>
#include <vector>

namespace gluray::test {

/// A surface: translucent unless its opacity is 1.
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
/// Three nested balls, and an opaque surface that intersects them.
std::vector<Layer> balls();

/// Draws `layer`, which `uploaded` holds, with `program`. `more` sets additional uniforms.
void drawLayer(Gl gl, GLuint program, const Upload& uploaded, const Layer& layer,
               const std::function<void()>& more = {});
/// The same with a mesh uploaded only for this draw.
void drawFresh(Gl gl, GLuint program, const Layer& layer);

/// A texture of the window's size without filtering; a bound framebuffer object of it and a depth buffer.
GLuint imageTexture(Gl gl, GLenum internalFormat);
GLuint imageFramebuffer(Gl gl, std::initializer_list<GLuint> colors);
/// Copies the colours of the framebuffer bound for reading to the window, and binds the window.
void showInWindow(Gl gl);

}  // namespace gluray::test
