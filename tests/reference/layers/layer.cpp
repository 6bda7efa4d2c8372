#include "tests/reference/layers/layer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <utility>

namespace gluray::test {

View placed(const glm::dvec3& at, double size) {
  View view = perspectiveView(20);
  view.eyeFromObject = glm::scale(glm::translate(view.eyeFromObject, at), glm::dvec3(size));
  return view;
}

Layer seen(ProgramMesh mesh, const glm::vec3& color, float opacity, const View& view) {
  Layer one;
  one.mesh = std::move(mesh);
  one.color = color;
  one.opacity = opacity;
  one.view = view;
  return one;
}

std::vector<Layer> balls() {
  std::vector<Layer> all;
  all.push_back(seen(ball(24), {1, 0.3f, 0.2f}, 0.4f, placed({0, 0, 0}, 1.1)));
  all.push_back(seen(ball(24), {0.2f, 0.9f, 0.3f}, 0.6f, placed({0.1, 0, 0}, 0.8)));
  all.push_back(seen(ball(24), {0.9f, 0.8f, 0.1f}, 1, placed({0.5, 0.2, 0}, 0.5)));
  all.push_back(seen(ball(16), {0.2f, 0.3f, 1}, 0.3f, placed({-0.3, 0.2, 0.1}, 0.4)));
  return all;
}

void drawLayer(Gl gl, GLuint program, const Upload& uploaded, const Layer& layer,
               const std::function<void()>& more) {
  gl.UseProgram(program);
  setAll(gl, program, layer.view, layer.surface);
  setVec3(gl, program, "diffuseColorUniform", layer.color);
  setVec3(gl, program, "ambientColorUniform", layer.color);
  setFloat(gl, program, "opacityUniform", layer.opacity);
  if (more) more();
  gl.BindVertexArray(uploaded.array);
  if (layer.before) layer.before(gl, program);
  gl.DrawElements(layer.mode, layer.mesh.count(), GL_UNSIGNED_INT, nullptr);
}

void drawFresh(Gl gl, GLuint program, const Layer& layer) {
  drawLayer(gl, program, upload(gl, layer.mesh, program), layer);
}

GLuint imageTexture(Gl gl, GLenum internalFormat) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), kProgramWidth, kProgramHeight, 0,
                GL_RGBA, GL_FLOAT, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return name;
}

GLuint imageFramebuffer(Gl gl, std::initializer_list<GLuint> colors) {
  GLuint name = 0, depth = 0;
  gl.GenFramebuffers(1, &name);
  gl.BindFramebuffer(GL_FRAMEBUFFER, name);
  std::vector<GLenum> buffers;
  for (const GLuint color : colors) {
    buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, buffers.back(), GL_TEXTURE_2D, color, 0);
  }
  gl.GenRenderbuffers(1, &depth);
  gl.BindRenderbuffer(GL_RENDERBUFFER, depth);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kProgramWidth, kProgramHeight);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  gl.DrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  return name;
}

void showInWindow(Gl gl) {
  gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                     GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace gluray::test
