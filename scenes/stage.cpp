#include "scenes/stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace gluray::scenes {

void begin(Gl gl, int width, int height, Color background) {
  gl.Viewport(0, 0, width, height);
  gl.ClearColor(background[0], background[1], background[2], background[3]);
  gl.ClearDepth(1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST);
}

void camera(Gl gl, int width, int height, float distance) {
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadMatrixd(glm::value_ptr(glm::perspective(
      glm::radians(40.0), static_cast<double>(width) / static_cast<double>(height), 1.0, 20.0)));
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadMatrixd(
      glm::value_ptr(glm::lookAt(glm::dvec3(0, 1.2, distance), glm::dvec3(0), glm::dvec3(0, 1, 0))));
}

void flatCamera(Gl gl, int width, int height, double half) {
  const double across = half * static_cast<double>(width) / static_cast<double>(height);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Ortho(-across, across, -half, half, -10, 10);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
}

void tiltedCamera(Gl gl, int width, int height, double half) {
  flatCamera(gl, width, height, half);
  gl.Rotatef(20, 0, 1, 0);
}

void keyLight(Gl gl) {
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  light(gl, GL_LIGHT0, GL_POSITION, {0.6f, 1, 0.8f, 0});
}

void light(Gl gl, GLenum name, GLenum parameter, Color value) { gl.Lightfv(name, parameter, value.data()); }

void material(Gl gl, GLenum face, GLenum parameter, Color value) {
  gl.Materialfv(face, parameter, value.data());
}

void paint(Gl gl, float red, float green, float blue) {
  material(gl, GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, {red, green, blue, 1});
  material(gl, GL_FRONT_AND_BACK, GL_SPECULAR, {0, 0, 0, 1});
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 0);
}

void send(Gl gl, const Model& model, unsigned what) {
  gl.Begin(GL_TRIANGLES);
  for (const uint32_t i : model.indices) {
    if (what & kNormals) gl.Normal3fv(&model.normals[i * 3]);
    if (what & kColors) gl.Color4ubv(&model.colors[i * 4]);
    if (what & kTexcoords) gl.TexCoord2fv(&model.texcoords[i * 2]);
    gl.Vertex3fv(&model.positions[i * 3]);
  }
  gl.End();
}

void sendAt(Gl gl, const Model& model, float x, float y, float z, float scale, unsigned what) {
  gl.PushMatrix();
  gl.Translatef(x, y, z);
  gl.Scalef(scale, scale, scale);
  send(gl, model, what);
  gl.PopMatrix();
}

}  // namespace gluray::scenes
