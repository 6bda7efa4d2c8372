// What glPolygonOffset counts in, by the format of the depth buffer: the depths of a plain OpenGL and ours.
#include "tests/reference/framebuffer.h"
#include "tests/reference/traced_context.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::test {
namespace {

constexpr int kSize = 16;

/// Depths in the middle of surfaces here and there, moved by units alone, in a framebuffer object of
/// `format`.
std::vector<float> depths(const gl::RealGl& gl, GLenum format) {
  bindNewFramebuffer(gl, {kSize, kSize}, GL_RGBA8, format);
  gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_POLYGON_OFFSET_FILL);
  std::vector<float> found;
  for (const float units : {0.0f, 3.0f, 60000.0f, -70000.0f})
    for (const float z : {-0.9f, -0.6f, -0.2f, 0.2f, 0.7f}) {
      gl.PolygonOffset(0, units);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      // Not quite flat: surfaces without depth are rasterised.
      gl.Begin(GL_TRIANGLES);
      gl.Vertex3f(-1, -1, z), gl.Vertex3f(3, -1, z + 1e-3f), gl.Vertex3f(-1, 3, z);
      gl.End();
      float depth = 0;
      gl.ReadPixels(kSize / 2, kSize / 2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
      found.push_back(depth);
    }
  return found;
}

TEST(PolygonOffset, UnitsAreThoseOfTheDepthBuffer) {
  for (const GLenum format : {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT32F}) {
    const auto real = OsmesaContext::create();
    const std::vector<float> expected = depths(real->real(), format);
    const TracedContext traced;
    const std::vector<float> ours = depths(traced.gl(), format);
    EXPECT_GT(traced.context().statistics.drawsTraced, 0u);
    for (size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(ours[i], expected[i], 3e-7f) << "format " << format << ", number " << i;
  }
}

}  // namespace
}  // namespace gluray::test
