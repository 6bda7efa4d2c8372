// Materials: set between draws, per vertex, and from the vertex colour.
#include "scenes/families.h"
#include "scenes/stage.h"

namespace gluray::scenes {
namespace {

/// Five spheres, one for each mode of glColorMaterial.
void colorMaterialModes(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 6);
  keyLight(gl);
  light(gl, GL_LIGHT0, GL_AMBIENT, {0.3f, 0.3f, 0.3f, 1});
  const Model ball = sphere(20, 30);
  const GLenum modes[] = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE};
  for (int i = 0; i < 5; ++i) {
    paint(gl, 0.4f, 0.4f, 0.4f);
    gl.Materialf(GL_FRONT, GL_SHININESS, 10);
    material(gl, GL_FRONT, GL_EMISSION, {0, 0, 0, 1});
    gl.ColorMaterial(GL_FRONT, modes[i]);
    gl.Enable(GL_COLOR_MATERIAL);
    sendAt(gl, ball, static_cast<float>(i - 2) * 1.1f, 0, 0, 0.6f, kNormals | kColors);
    gl.Disable(GL_COLOR_MATERIAL);
  }
  paint(gl, 0.4f, 0.4f, 0.4f);  // Mesa forgets what the last vertex's colour did to the material
}

void colorMaterialTwoSided(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  material(gl, GL_BACK, GL_DIFFUSE, {0.9f, 0.9f, 0.1f, 1});
  gl.ColorMaterial(GL_FRONT, GL_DIFFUSE);
  gl.Enable(GL_COLOR_MATERIAL);
  gl.Rotatef(-60, 1, 0, 0);
  gl.Rotatef(90, 0, 1, 0);
  send(gl, sheet(20), kNormals | kColors);
}

/// glMaterial inside glBegin, and a colour that outlives glColorMaterial.
void materialInsideBegin(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  const Model m = torus(0.8f, 0.4f, 24, 12);
  gl.Begin(GL_TRIANGLES);
  for (size_t t = 0; t < m.indices.size() / 3; ++t) {
    const float share = static_cast<float>(t % 24) / 23.0f;
    material(gl, GL_FRONT, GL_DIFFUSE, {share, 1 - share, 0.3f, 1});
    if (t == m.indices.size() / 6) material(gl, GL_FRONT, GL_AMBIENT, {0.9f, 0, 0, 1});
    for (size_t k = 0; k < 3; ++k) {
      gl.Normal3fv(&m.normals[m.indices[t * 3 + k] * 3]);
      gl.Vertex3fv(&m.positions[m.indices[t * 3 + k] * 3]);
    }
  }
  gl.End();
  // The last material holds on.
  sendAt(gl, sphere(10, 16), 0, 0, 0, 0.3f);
}

void materialsBetweenDraws(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 6);
  keyLight(gl);
  gl.Enable(GL_NORMALIZE);
  const Model ball = sphere(12, 16);
  for (int i = 0; i < 25; ++i) {
    const float x = static_cast<float>(i % 5) / 4.0f, y = static_cast<float>(i / 5) / 4.0f;
    paint(gl, x, y, 1 - x);
    material(gl, GL_FRONT, GL_SPECULAR, {y, y, y, 1});
    gl.Materialf(GL_FRONT, GL_SHININESS, 1 + 60 * x);
    sendAt(gl, ball, 4 * x - 2, 3 * y - 1.5f, 0, 0.3f);
  }
}

/// Unlit colours, current when the list of vertices starts, and changed by it.
void carriedColor(Gl gl, int width, int height) {
  begin(gl, width, height);
  tiltedCamera(gl, width, height);
  gl.Color3f(0.9f, 0.2f, 0.2f);
  for (int i = 0; i < 4; ++i) {
    const float x = -1.2f + 0.6f * static_cast<float>(i);
    gl.Begin(GL_TRIANGLES);
    gl.Vertex2f(x, -0.5f);
    if (i == 1) gl.Color3f(0.2f, 0.9f, 0.2f);
    gl.Vertex2f(x + 0.5f, -0.5f);
    gl.Vertex2f(x, 0.5f);
    if (i == 2) gl.Color3f(0.2f, 0.2f, 0.9f);
    gl.End();
  }
  gl.PushAttrib(GL_CURRENT_BIT);
  gl.Color3f(1, 1, 1);
  gl.Rectf(-1.2f, 0.6f, 0, 0.8f);
  gl.PopAttrib();
  gl.Rectf(0.1f, 0.6f, 1.2f, 0.8f);
}

constexpr Scene kMaterialScenes[] = {
    {"color-material-modes", colorMaterialModes},
    {"color-material-two-sided", colorMaterialTwoSided},
    {"material-inside-begin", materialInsideBegin},
    {"materials-between-draws", materialsBetweenDraws},
    {"carried-color", carriedColor},
};

}  // namespace

std::span<const Scene> materialScenes() { return kMaterialScenes; }

}  // namespace gluray::scenes
