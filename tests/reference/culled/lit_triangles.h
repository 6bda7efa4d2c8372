// Triangles that the real OpenGL draws and light.rasterised lights, with images of them.
#pragma once
#include "tests/reference/culled/drawn_triangles.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace gluray::test::raster_light {

constexpr int kSize = 128, kBlock = 8;  // pixels
inline const glm::vec3 kTint(0.8f, 0.6f, 0.4f);

inline const char* const kFlatVertex = R"(#version 120
attribute vec3 position;
uniform mat4 clipFromEye, eyeFromObject;
void main() { gl_Position = clipFromEye * (eyeFromObject * vec4(position, 1.0)); })";
inline const char* const kFlatFragment = R"(#version 120
uniform vec3 tint;
void main() { gl_FragColor = vec4(tint, 1.0); })";
inline const char* const kHoles = R"(#version 120
uniform vec3 tint;
void main() {
  if (fract(gl_FragCoord.x / 16.0) < 0.5) discard;
  gl_FragColor = vec4(tint, 1.0);
})";

inline Settings lit(bool on) {
  Settings settings = TracedContext::tracing();
  settings.light.rasterised = on;
  settings.ao.enabled = true, settings.ao.samples = 256, settings.ao.radius = 1;
  return settings;
}

inline Triangles square(float y, float half) {
  Triangles all;
  addQuad(all, {-half, y, half}, {half, y, half}, {half, y, -half}, {-half, y, -half});
  return all;
}

/// A floor and two walls that stand on it.
inline Triangles corner() {
  Triangles all = square(0, 1);
  addQuad(all, {-1, 0, -1}, {1, 0, -1}, {1, 1, -1}, {-1, 1, -1});
  addQuad(all, {-1, 0, 1}, {-1, 0, -1}, {-1, 1, -1}, {-1, 1, 1});
  return all;
}

inline glm::mat4 camera() { return glm::perspective(glm::radians(45.0f), 1.0f, 0.5f, 20.0f); }
inline glm::mat4 view() { return glm::lookAt(glm::vec3(2, 2, 3), glm::vec3(0, 0.3f, 0), glm::vec3(0, 1, 0)); }

inline void begin(Gl gl) {
  gl.Viewport(0, 0, kSize, kSize);
  gl.ClearColor(0.1f, 0.2f, 0.3f, 1), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LESS);
}

inline void draw(Gl gl, GLuint program, const Triangles& triangles, const glm::mat4& eyeFromObject = view(),
                 const glm::vec3& tint = kTint, GLsizei indices = 0) {
  drawTriangles(gl, program, triangles, {camera(), eyeFromObject, tint, indices});
}

/// Draws by fixed function, which is traced.
inline void drawTraced(Gl gl, const Triangles& triangles, const glm::vec3& tint = kTint) {
  const glm::mat4 clip = camera(), eye = view();
  gl.MatrixMode(GL_PROJECTION), gl.LoadMatrixf(glm::value_ptr(clip));
  gl.MatrixMode(GL_MODELVIEW), gl.LoadMatrixf(glm::value_ptr(eye));
  gl.Color3f(tint.x, tint.y, tint.z);
  gl.Begin(GL_TRIANGLES);
  for (const glm::vec3& p : triangles) gl.Vertex3f(p.x, p.y, p.z);
  gl.End();
}

inline CountedImage seen(const Settings& settings, const std::function<void(Gl)>& frame) {
  return seenThrough(settings, kSize, [&](Gl gl) {
    begin(gl);
    frame(gl);
  });
}

inline CountedImage byProgram(const Settings& settings, const char* fragment = kFlatFragment) {
  return seen(settings, [&](Gl gl) { draw(gl, makeProgram(gl, kFlatVertex, fragment), corner()); });
}

inline int channel(uint32_t color, int c) { return static_cast<int>(color >> (8 * c) & 255); }

inline uint32_t at(const DrawnImage& p, int x, int y) { return p.colors[static_cast<size_t>(y * kSize + x)]; }

/// The pixel that shows a point.
inline uint32_t at(const DrawnImage& p, const glm::vec3& point) {
  return p.colors[pixelOf(p, camera() * view(), point)];
}

/// Mean of the channels in a block of pixels.
inline std::array<double, 3> meanOf(const DrawnImage& p, int x0, int y0) {
  std::array<double, 3> mean{};
  for (int y = y0; y < y0 + kBlock; ++y)
    for (int x = x0; x < x0 + kBlock; ++x)
      for (int c = 0; c < 3; ++c) mean[static_cast<size_t>(c)] += channel(at(p, x, y), c);
  for (double& m : mean) m /= kBlock * kBlock;
  return mean;
}

inline void expectAlike(const DrawnImage& a, const DrawnImage& b, double most) {
  for (int y = 0; y < kSize; y += kBlock)
    for (int x = 0; x < kSize; x += kBlock) {
      const auto one = meanOf(a, x, y), other = meanOf(b, x, y);
      for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(one[c], other[c], most) << x << ", " << y << ", " << c;
    }
}

}  // namespace gluray::test::raster_light
