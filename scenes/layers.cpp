// Cameras, viewports, clears and overlays: several images in one frame, in order.
#include "scenes/families.h"
#include "scenes/stage.h"

#include <cmath>

namespace gluray::scenes {
namespace {

void offAxisFrustum(Gl gl, int width, int height) {
  begin(gl, width, height);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-0.3, 0.9, -0.7, 0.2, 1, 12);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(0.7f, -0.6f, -3);
  keyLight(gl);
  paint(gl, 0.9f, 0.6f, 0.6f);
  send(gl, torus(0.8f, 0.4f, 50, 24));
}

void orthographic(Gl gl, int width, int height) {
  begin(gl, width, height);
  flatCamera(gl, width, height, 1.3);
  keyLight(gl);
  paint(gl, 0.5f, 0.8f, 0.9f);
  gl.Rotatef(35, 1, 0, 0);
  gl.Rotatef(45, 0, 1, 0);
  send(gl, vase(40, 30));
}

/// Eye coordinates of a million: what counts is relative.
void farFromTheOrigin(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.8f, 0.8f, 0.3f);
  gl.Scaled(1e-4, 1e-4, 1e-4);
  gl.Enable(GL_NORMALIZE);
  const Model m = sphere(24, 36);
  gl.Begin(GL_TRIANGLES);
  for (const uint32_t i : m.indices) {
    gl.Normal3fv(&m.normals[i * 3]);
    gl.Vertex3f(m.positions[i * 3] * 1e4f, m.positions[i * 3 + 1] * 1e4f, m.positions[i * 3 + 2] * 1e4f);
  }
  gl.End();
}

/// Four views, each in its corner, cleared on its own.
void fourViews(Gl gl, int width, int height) {
  begin(gl, width, height, {0, 0, 0, 1});
  const Model m = vase(30, 20);
  gl.Enable(GL_SCISSOR_TEST);
  for (int i = 0; i < 4; ++i) {
    const int x = i % 2 * (width / 2), y = i / 2 * (height / 2), w = width / 2 - 4, h = height / 2 - 4;
    gl.Viewport(x, y, w, h);
    gl.Scissor(x + 3, y + 5, w - 10, h - 8);
    gl.ClearColor(0.2f * static_cast<float>(i), 0.3f, 0.4f, 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (i == 3)
      flatCamera(gl, w, h, 1.2);
    else
      camera(gl, w, h);
    keyLight(gl);
    paint(gl, 0.8f, 0.8f - 0.2f * static_cast<float>(i), 0.4f);
    gl.Rotatef(30.0f * static_cast<float>(i), 1, 0, 0);
    send(gl, m);
  }
}

/// A depth-only clear starts a layer over the old one: an axes cross in the corner.
void layeredClears(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.3f, 0.5f, 0.8f);
  send(gl, torus(0.9f, 0.4f, 50, 24));
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Viewport(0, 0, width / 3, height / 3);
  camera(gl, width, height);
  gl.Enable(GL_NORMALIZE);
  const Model ball = sphere(10, 16);
  paint(gl, 0.9f, 0.2f, 0.2f);
  sendAt(gl, ball, 0.8f, 0, 0, 0.5f);
  paint(gl, 0.2f, 0.9f, 0.2f);
  sendAt(gl, ball, 0, 0.8f, 0, 0.5f);
  paint(gl, 0.9f, 0.9f, 0.9f);
  sendAt(gl, ball, 0, 0, 0, 0.6f);
}

/// The background is a gradient drawn in 2D without depth test; only depth is cleared.
void gradientBackground(Gl gl, int width, int height) {
  begin(gl, width, height, {1, 0, 1, 1});
  flatCamera(gl, width, height);
  gl.Disable(GL_DEPTH_TEST);
  gl.Begin(GL_QUADS);
  gl.Color3f(0.1f, 0.1f, 0.3f), gl.Vertex2f(-3, -1), gl.Vertex2f(3, -1);
  gl.Color3f(0.7f, 0.8f, 0.9f), gl.Vertex2f(3, 1), gl.Vertex2f(-3, 1);
  gl.End();
  gl.Enable(GL_DEPTH_TEST);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.8f, 0.3f, 0.3f);
  send(gl, sphere(24, 36));
}

/// A scale bar and a frame in 2D over the scene, depth test off.
void overlay2d(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.4f, 0.8f, 0.4f);
  send(gl, sphere(24, 36));
  gl.Disable(GL_LIGHTING);
  gl.Disable(GL_DEPTH_TEST);
  flatCamera(gl, width, height);
  gl.Color3f(1, 1, 1), gl.Rectf(-0.6f, -0.1f, 0.6f, 0.05f);
  gl.Color3f(0, 0, 0), gl.Rectf(-0.5f, -0.08f, 0.1f, 0.03f);
  gl.Enable(GL_DEPTH_TEST);
  gl.Color3f(1, 0, 0), gl.Rectf(-1, 0.5f, 1, 0.6f);  // depth test on: behind the sphere or not
}

/// Bitmaps at raster positions: positions use the modelview matrix of their own moment, and are hidden behind
/// surfaces.
void bitmapLabels(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.5f, 0.5f, 0.9f);
  send(gl, sphere(24, 36));
  gl.Disable(GL_LIGHTING);
  const GLubyte glyph[] = {0x81, 0xc3, 0xe7, 0xff, 0xbd, 0x99, 0x81, 0x81};
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int i = 0; i < 12; ++i) {
    const float angle = 0.5236f * static_cast<float>(i);
    gl.Color3f(1, static_cast<float>(i) / 12.0f, 0);
    gl.RasterPos3f(1.15f * std::cos(angle), 0.2f, 1.15f * std::sin(angle));
    for (int k = 0; k < 3; ++k) gl.Bitmap(8, 8, 4, 4, 9, 0, glyph);
  }
}

/// No clear in between: what is drawn second meets the depth of what was drawn first.
void twoPasses(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.8f, 0.8f, 0.8f);
  send(gl, torus(0.9f, 0.3f, 40, 20));
  gl.Flush();
  gl.Finish();
  paint(gl, 0.9f, 0.5f, 0.1f);
  gl.Rotatef(90, 1, 0, 0);
  send(gl, torus(0.9f, 0.3f, 40, 20));
}

void colorMaskedClears(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.8f, 0.3f, 0.6f);
  send(gl, sphere(20, 30));
  gl.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
  gl.Enable(GL_SCISSOR_TEST);
  gl.Scissor(width / 2, 0, width / 2, height);
  gl.ClearColor(0, 1, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.Disable(GL_SCISSOR_TEST);
  sendAt(gl, sphere(20, 30), 0, 0.9f, 0, 0.4f);  // green channel only
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  sendAt(gl, sphere(20, 30), 0, -0.9f, 0, 0.4f);
}

constexpr Scene kLayerScenes[] = {
    {"off-axis-frustum", offAxisFrustum},
    {"orthographic", orthographic},
    {"large-coordinates", farFromTheOrigin},
    {"four-views", fourViews},
    {"layered-clears", layeredClears},
    {"gradient-background", gradientBackground},
    {"overlay-2d", overlay2d},
    {"bitmap-labels", bitmapLabels},
    {"two-passes", twoPasses},
    {"color-masked-clears", colorMaskedClears},
};

}  // namespace

std::span<const Scene> layerScenes() { return kLayerScenes; }

}  // namespace gluray::scenes
