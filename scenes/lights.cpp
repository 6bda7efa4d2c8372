// The lighting equation, term by term.
#include "scenes/families.h"
#include "scenes/stage.h"

namespace gluray::scenes {
namespace {

void directionalLight(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.4f, 0.2f);
  gl.Rotatef(-50, 1, 0, 0);
  send(gl, torus(0.9f, 0.4f, 60, 30));
}

void pointLight(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT1);  // not the first light, whose defaults are others
  light(gl, GL_LIGHT1, GL_DIFFUSE, {1, 1, 0.8f, 1});
  light(gl, GL_LIGHT1, GL_POSITION, {0.5f, 1.3f, 0.7f, 1});
  gl.Lightf(GL_LIGHT1, GL_CONSTANT_ATTENUATION, 0.4f);
  gl.Lightf(GL_LIGHT1, GL_LINEAR_ATTENUATION, 0.3f);
  gl.Lightf(GL_LIGHT1, GL_QUADRATIC_ATTENUATION, 0.5f);
  paint(gl, 0.7f, 0.7f, 0.9f);
  send(gl, sphere(30, 40));
}

void spotLight(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 3.5f);
  gl.Enable(GL_LIGHTING);
  gl.Enable(GL_LIGHT0);
  gl.Enable(GL_LIGHT2);
  light(gl, GL_LIGHT0, GL_POSITION, {-0.6f, 0.3f, 1.5f, 1});
  light(gl, GL_LIGHT0, GL_SPOT_DIRECTION, {0.1f, -0.1f, -1, 0});
  gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 25);
  gl.Lightf(GL_LIGHT0, GL_SPOT_EXPONENT, 0);
  light(gl, GL_LIGHT2, GL_DIFFUSE, {1, 0.6f, 0.2f, 1});
  light(gl, GL_LIGHT2, GL_POSITION, {0.6f, 0, 1.2f, 1});
  light(gl, GL_LIGHT2, GL_SPOT_DIRECTION, {0, 0, -2, 0});
  gl.Lightf(GL_LIGHT2, GL_SPOT_CUTOFF, 40);
  gl.Lightf(GL_LIGHT2, GL_SPOT_EXPONENT, 12);
  paint(gl, 0.8f, 0.8f, 0.8f);
  gl.Rotatef(-30, 1, 0, 0);
  send(gl, sheet(60));
}

void eightLights(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  gl.Enable(GL_LIGHTING);
  for (int i = 0; i < 8; ++i) {
    const GLenum name = GL_LIGHT0 + static_cast<GLenum>(i);
    const float s = i & 1 ? 1.0f : -1.0f, t = i & 2 ? 1.0f : -1.0f;
    gl.Enable(name);
    light(gl, name, GL_DIFFUSE,
          {i % 3 == 0 ? 0.5f : 0.05f, i % 3 == 1 ? 0.5f : 0.05f, i % 3 == 2 ? 0.5f : 0.05f, 1});
    light(gl, name, GL_SPECULAR, {0.2f, 0.2f, 0.2f, 1});
    light(gl, name, GL_AMBIENT, {0.02f, 0.02f, 0.02f, 1});
    light(gl, name, GL_POSITION, {2 * s, 2 * t, i & 4 ? 2.0f : -0.5f, i & 4 ? 1.0f : 0.0f});
  }
  gl.Disable(GL_LIGHT5);
  paint(gl, 0.9f, 0.9f, 0.9f);
  material(gl, GL_FRONT, GL_SPECULAR, {1, 1, 1, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 20);
  send(gl, vase(40, 30));
}

void glossy(Gl gl, int width, int height, bool localViewer) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  gl.LightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, localViewer);
  paint(gl, 0.1f, 0.2f, 0.5f);
  material(gl, GL_FRONT, GL_SPECULAR, {0.9f, 0.9f, 0.6f, 1});
  gl.Materialf(GL_FRONT, GL_SHININESS, 30);
  gl.Enable(GL_NORMALIZE);
  const Model ball = sphere(60, 80);
  sendAt(gl, ball, -1, 0, 0, 0.7f);
  gl.Materialf(GL_FRONT, GL_SHININESS, 0);  // anything to the power of 0 is 1
  sendAt(gl, ball, 0.9f, 0, 0, 0.7f);
}
void specular(Gl gl, int width, int height) { glossy(gl, width, height, false); }
void localViewer(Gl gl, int width, int height) { glossy(gl, width, height, true); }

void twoSided(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  gl.LightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  material(gl, GL_FRONT, GL_AMBIENT_AND_DIFFUSE, {0.9f, 0.3f, 0.2f, 1});
  material(gl, GL_BACK, GL_AMBIENT_AND_DIFFUSE, {0.2f, 0.5f, 0.9f, 1});
  material(gl, GL_BACK, GL_EMISSION, {0.1f, 0, 0.1f, 1});
  gl.Rotatef(40, 1, 0, 0);
  send(gl, vase(40, 30));
  gl.FrontFace(GL_CW);
  gl.Rotatef(60, 0, 1, 0);
  sendAt(gl, sheet(20), 1.2f, 0, 0, 0.5f);
}

void globalAmbientAndEmission(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  const float ambient[] = {0.5f, 0.1f, 0.3f, 1};
  gl.LightModelfv(GL_LIGHT_MODEL_AMBIENT, ambient);
  light(gl, GL_LIGHT0, GL_AMBIENT, {0.1f, 0.2f, 0, 1});
  light(gl, GL_LIGHT0, GL_DIFFUSE, {0.5f, 0.5f, 0.4f, 1});
  material(gl, GL_FRONT, GL_AMBIENT, {0.6f, 0.6f, 0.9f, 1});
  material(gl, GL_FRONT, GL_EMISSION, {0, 0.15f, 0.05f, 1});
  send(gl, sphere(20, 30));
}

/// A light belongs to the modelview matrix of the moment it is set.
void movingLight(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 5);
  keyLight(gl);
  const Model ball = sphere(20, 30);
  gl.Enable(GL_NORMALIZE);
  for (int i = -1; i <= 1; ++i) {
    gl.PushMatrix();
    gl.Translatef(1.4f * static_cast<float>(i), 0, 0);
    gl.Rotatef(70 * static_cast<float>(i), 0, 1, 0);
    light(gl, GL_LIGHT0, GL_POSITION, {0.3f, 0.4f, 1, static_cast<float>(i == 0)});
    paint(gl, 0.8f, 0.6f, 0.4f);
    send(gl, ball);
    gl.PopMatrix();
  }
}

/// Normals that are not of unit length: used as they are, rescaled, normalised.
void normalLengths(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height, 5);
  keyLight(gl);
  paint(gl, 0.5f, 0.5f, 0.5f);
  const Model ball = sphere(20, 30);
  sendAt(gl, ball, -1.5f, 0.6f, 0, 0.6f);  // scaling the model lengthens its normals
  sendAt(gl, ball, -1.5f, -0.7f, 0, 1.1f);
  gl.Enable(GL_RESCALE_NORMAL);
  sendAt(gl, ball, 0, 0.6f, 0, 0.6f);
  gl.Disable(GL_RESCALE_NORMAL);
  gl.Enable(GL_NORMALIZE);
  gl.PushMatrix();
  gl.Translatef(1.5f, 0, 0);
  gl.Scalef(0.4f, 1.2f, 0.7f);
  send(gl, ball);
  gl.PopMatrix();
  sendAt(gl, ball, 0, -0.7f, 0, 0.6f);
}

constexpr Scene kLightScenes[] = {
    {"directional-light", directionalLight},
    {"point-light", pointLight},
    {"spot-light", spotLight},
    {"eight-lights", eightLights},
    {"specular", specular},
    {"local-viewer", localViewer},
    {"two-sided", twoSided},
    {"ambient-emission", globalAmbientAndEmission},
    {"moving-light", movingLight},
    {"normal-lengths", normalLengths},
};

}  // namespace

std::span<const Scene> lightScenes() { return kLightScenes; }

}  // namespace gluray::scenes
