// Draws lines and points flat, with the real OpenGL, and as tubes and spheres through GLuRay.
#pragma once
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace gluray::test {

using DrawLines = std::function<void(const gl::RealGl&)>;

constexpr int kLineStage = 64;  // pixels, both sides of the window

struct LineImage {
  DrawnImage image;
  gl::Statistics statistics;

  size_t at(int x, int y) const { return static_cast<size_t>(y) * kLineStage + static_cast<size_t>(x); }
  bool covered(int x, int y) const { return image.depths[at(x, y)] < 1; }
  float depth(int x, int y) const { return image.depths[at(x, y)]; }
  int channel(int x, int y, int c) const { return static_cast<int>(image.colors[at(x, y)] >> (8 * c) & 255); }
  int coveredInColumn(int x) const {
    int count = 0;
    for (int y = 0; y < kLineStage; ++y) count += covered(x, y);
    return count;
  }
  int coveredInAll() const {
    int count = 0;
    for (int x = 0; x < kLineStage; ++x) count += coveredInColumn(x);
    return count;
  }
};

inline Settings asTubes() {
  Settings settings = TracedContext::tracing();
  settings.lines.look = LineLook::tubes;
  settings.points.look = PointLook::spheres;
  return settings;
}

/// A narrow perspective view along -z, from (0, 0, 8), of what lies between z = 3 and z = -7. At z = -2 the
/// window is 4 units wide, and the eye is 10 away.
inline void prepareLineStage(const gl::RealGl& gl) {
  gl.Viewport(0, 0, kLineStage, kLineStage);
  gl.MatrixMode(GL_PROJECTION);
  gl.LoadIdentity();
  gl.Frustum(-1, 1, -1, 1, 5, 15);
  gl.MatrixMode(GL_MODELVIEW);
  gl.LoadIdentity();
  gl.Translatef(0, 0, -8);
  gl.Enable(GL_DEPTH_TEST);
  gl.ClearColor(0, 0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

inline LineImage drawnFlat(const DrawLines& draw) {
  const auto context = OsmesaContext::create({kLineStage, kLineStage});
  prepareLineStage(context->real());
  draw(context->real());
  return {readImage(context->real(), kLineStage, kLineStage), {}};
}

inline LineImage drawnRound(const DrawLines& draw, const Settings& settings = asTubes()) {
  TracedContext context({kLineStage, kLineStage}, settings);
  prepareLineStage(context.gl());
  draw(context.gl());
  EXPECT_EQ(context.gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  DrawnImage image = context.read();
  return {std::move(image), context.context().counts.statistics};
}

inline uint64_t rasterisedBecause(const LineImage& image, gl::Reason reason) {
  return image.statistics.rasterisedBecause[static_cast<size_t>(reason)];
}

}  // namespace gluray::test
