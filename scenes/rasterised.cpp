// What the real OpenGL draws, merged with what is traced.
#include "scenes/families.h"
#include "scenes/stage.h"

#include <cmath>

namespace gluray::scenes {
namespace {

/// A traced torus for the others to meet.
void host(Gl gl, int width, int height) {
  begin(gl, width, height);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.8f, 0.6f, 0.4f);
  send(gl, torus(0.9f, 0.35f, 50, 24));
}

/// Translucent sheets, blended back to front without depth writes.
void translucentSheets(Gl gl, int width, int height) {
  host(gl, width, height);
  gl.Disable(GL_LIGHTING);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  gl.DepthMask(GL_FALSE);
  for (int i = 0; i < 3; ++i) {
    gl.Color4f(0.2f, 0.3f * static_cast<float>(i), 0.9f, 0.4f);
    const float z = -0.5f + 0.5f * static_cast<float>(i);
    gl.Begin(GL_QUADS);
    gl.Vertex3f(-1, -0.6f, z), gl.Vertex3f(1, -0.6f, z), gl.Vertex3f(1, 0.6f, z), gl.Vertex3f(-1, 0.6f, z);
    gl.End();
  }
}

/// Blending left on with alpha 1, and additive glow.
void blendingKinds(Gl gl, int width, int height) {
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  host(gl, width, height);
  gl.BlendFunc(GL_ONE, GL_ONE);
  gl.DepthMask(GL_FALSE);
  paint(gl, 0.3f, 0.1f, 0);
  sendAt(gl, sphere(16, 24), 0, 0, 0, 0.7f);
  gl.DepthMask(GL_TRUE);
  gl.BlendFunc(GL_ONE, GL_ZERO);
  paint(gl, 0.1f, 0.8f, 0.2f);
  sendAt(gl, sphere(16, 24), 0, 0, 0, 0.3f);
}

void linesAndPoints(Gl gl, int width, int height) {
  host(gl, width, height);
  gl.Disable(GL_LIGHTING);
  gl.LineWidth(3);
  gl.Begin(GL_LINE_STRIP);
  for (int i = 0; i <= 200; ++i) {
    const float a = 0.15f * static_cast<float>(i);
    gl.Color3f(static_cast<float>(i) / 200.0f, 1, 0);
    gl.Vertex3f(std::cos(a), std::sin(a), -1 + 0.01f * static_cast<float>(i));
  }
  gl.End();
  gl.PointSize(5);
  gl.Begin(GL_POINTS);
  for (int i = 0; i < 60; ++i) {
    const float a = 0.7f * static_cast<float>(i);
    gl.Color3f(1, 0, static_cast<float>(i) / 60.0f);
    gl.Vertex3f(1.2f * std::cos(a), 1.2f * std::sin(a) * 0.6f, std::sin(2 * a));
  }
  gl.End();
  gl.Enable(GL_LINE_STIPPLE);
  gl.LineStipple(2, 0x3333);
  gl.Begin(GL_LINE_LOOP);
  gl.Vertex3f(-1, -1, 0), gl.Vertex3f(1, -1, 0), gl.Vertex3f(1, 1, 0), gl.Vertex3f(-1, 1, 0);
  gl.End();
}

void wireframe(Gl gl, int width, int height) {
  host(gl, width, height);
  gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  paint(gl, 0.2f, 0.9f, 0.9f);
  sendAt(gl, sphere(10, 16), 0, 0, 0, 0.9f);
  gl.PolygonMode(GL_FRONT, GL_FILL);
  gl.PolygonMode(GL_BACK, GL_POINT);
  sendAt(gl, sphere(10, 16), 0, 0, 0, 0.3f);
}

/// An opaque ball, a quad that fades out, and a ball that the test rejects whole.
void alphaTest(Gl gl, int width, int height) {
  host(gl, width, height);
  gl.Disable(GL_LIGHTING);
  gl.Enable(GL_ALPHA_TEST);
  gl.AlphaFunc(GL_GREATER, 0.5f);
  gl.Color4f(0.2f, 0.4f, 0.9f, 1), sendAt(gl, sphere(10, 16), -0.4f, -0.5f, 0.2f, 0.4f);
  gl.AlphaFunc(GL_LESS, 0.5f);
  gl.Color4f(0.2f, 0.9f, 0.4f, 1), sendAt(gl, sphere(10, 16), 0.4f, -0.5f, 0.2f, 0.4f);
  gl.AlphaFunc(GL_GREATER, 0.5f);
  gl.Begin(GL_QUADS);
  gl.Color4f(1, 1, 0, 0), gl.Vertex3f(-1, -0.3f, 0.3f), gl.Vertex3f(1, -0.3f, 0.3f);
  gl.Color4f(1, 0, 0, 1), gl.Vertex3f(1, 0.6f, 0.3f), gl.Vertex3f(-1, 0.6f, 0.3f);
  gl.End();
}

/// A hole cut by the stencil.
void stencil(Gl gl, int width, int height) {
  begin(gl, width, height);
  gl.ClearStencil(0);
  gl.Clear(GL_STENCIL_BUFFER_BIT);
  flatCamera(gl, width, height);
  gl.Enable(GL_STENCIL_TEST);
  gl.StencilFunc(GL_ALWAYS, 1, 0xff);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
  gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE), gl.DepthMask(GL_FALSE);
  gl.Rectf(-0.5f, -0.5f, 0.7f, 0.4f);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE), gl.DepthMask(GL_TRUE);
  gl.StencilFunc(GL_EQUAL, 0, 0xff);
  gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
  camera(gl, width, height);
  keyLight(gl);
  paint(gl, 0.9f, 0.5f, 0.7f);
  send(gl, sphere(20, 30));
  gl.Disable(GL_STENCIL_TEST);
  sendAt(gl, sphere(20, 30), 0.1f, 0, 0, 0.35f);
}

void fog(Gl gl, int width, int height) {
  host(gl, width, height);
  gl.Enable(GL_FOG);
  gl.Fogi(GL_FOG_MODE, GL_LINEAR);
  gl.Fogf(GL_FOG_START, 3);
  gl.Fogf(GL_FOG_END, 5);
  const float gray[] = {0.5f, 0.5f, 0.5f, 1};
  gl.Fogfv(GL_FOG_COLOR, gray);
  gl.Rotatef(90, 1, 0, 0);
  send(gl, torus(0.9f, 0.2f, 40, 16));
}

/// Stippled polygons stand for transparency.
void stipple(Gl gl, int width, int height) {
  host(gl, width, height);
  GLubyte mask[128];
  for (int i = 0; i < 128; ++i) mask[i] = (i / 4) % 2 ? 0x55 : 0xaa;
  gl.PolygonStipple(mask);
  gl.Enable(GL_POLYGON_STIPPLE);
  paint(gl, 0.1f, 0.1f, 0.9f);
  sendAt(gl, sphere(20, 30), 0.3f, 0, 0.3f, 0.8f);
}

/// Texture coordinates made by the real OpenGL, two texture units.
void generatedCoordinates(Gl gl, int width, int height) {
  host(gl, width, height);
  const GLubyte texels[] = {255, 255, 255, 255, 40, 40, 160, 255, 40, 160, 40, 255, 255, 255, 0, 255};
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  gl.Enable(GL_TEXTURE_2D);
  gl.TexGeni(GL_S, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
  gl.TexGeni(GL_T, GL_TEXTURE_GEN_MODE, GL_SPHERE_MAP);
  gl.Enable(GL_TEXTURE_GEN_S), gl.Enable(GL_TEXTURE_GEN_T);
  paint(gl, 1, 1, 1);
  sendAt(gl, sphere(20, 30), 0, 0, 0, 0.5f);
}

/// Depth writes off, depth test off, in the middle of traced surfaces.
void depthOffInBetween(Gl gl, int width, int height) {
  host(gl, width, height);
  const Model ball = sphere(16, 24);
  gl.DepthMask(GL_FALSE);
  paint(gl, 0.9f, 0.1f, 0.1f);
  sendAt(gl, ball, -0.5f, 0, 0, 0.5f);
  gl.DepthMask(GL_TRUE);
  paint(gl, 0.1f, 0.9f, 0.1f);
  sendAt(gl, ball, -0.5f, 0, -0.5f, 0.5f);
  gl.Disable(GL_DEPTH_TEST);
  paint(gl, 0.1f, 0.1f, 0.9f);
  sendAt(gl, ball, 0.6f, 0, -0.5f, 0.4f);
  gl.Enable(GL_DEPTH_TEST);
  paint(gl, 0.9f, 0.9f, 0.1f);
  sendAt(gl, ball, 0.8f, 0.3f, 0, 0.4f);
}

constexpr Scene kRasterScenes[] = {
    {"translucent-sheets", translucentSheets},
    {"blending-kinds", blendingKinds},
    {"lines-and-points", linesAndPoints},
    {"wireframe", wireframe},
    {"alpha-test", alphaTest},
    {"stencil", stencil},
    {"fog", fog},
    {"polygon-stipple", stipple},
    {"generated-coordinates", generatedCoordinates},
    {"depth-off-in-between", depthOffInBetween},
};

}  // namespace

std::span<const Scene> rasterScenes() { return kRasterScenes; }

}  // namespace gluray::scenes
