// Queries that count draws have the same results as without GLuRay; state of later versions is never ignored.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
constexpr int kQuerySize = 48;

void triangle(Gl gl, float z) {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(-0.8f, -0.8f, z), gl.Vertex3f(0.8f, -0.8f, z + 0.1f), gl.Vertex3f(0, 0.8f, z);
  gl.End();
}

GLuint samplesPassed(Gl gl) {
  GLuint query = 0, samples = 0;
  gl.Enable(GL_DEPTH_TEST);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  triangle(gl, 0.5f);
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_SAMPLES_PASSED, query);
  triangle(gl, 0);
  gl.EndQuery(GL_SAMPLES_PASSED);
  triangle(gl, -0.5f);
  gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
  return samples;
}

TEST(Queries, CountWhatTheRealOneCounts) {
  const auto real = OsmesaContext::create({kQuerySize, kQuerySize});
  const GLuint expected = samplesPassed(real->real());
  TracedContext ours({kQuerySize, kQuerySize});
  EXPECT_EQ(samplesPassed(ours.gl()), expected);
  EXPECT_GT(expected, 0u);
  EXPECT_EQ(ours.context().counts.statistics.drawsTraced, 2u) << "draws outside of the query are traced";
  EXPECT_EQ(ours.context().counts.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::query)], 1u);
}

TEST(Queries, ConditionalDrawsFollowTheirQuery) {
  TracedContext ours({kQuerySize, kQuerySize});
  Gl gl = ours.gl();
  gl.Enable(GL_DEPTH_TEST), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  GLuint query = 0;
  gl.GenQueries(1, &query);
  gl.BeginQuery(GL_SAMPLES_PASSED, query), gl.EndQuery(GL_SAMPLES_PASSED);  // nothing passed
  gl.BeginConditionalRender(query, GL_QUERY_WAIT);
  gl.Color3f(1, 0, 0), triangle(gl, 0);
  gl.EndConditionalRender();
  uint32_t pixel = 0;
  gl.ReadPixels(kQuerySize / 2, kQuerySize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  EXPECT_EQ(pixel & 0xFF, 0u) << "the draw must not appear";
}

struct Rare {
  const char* name;
  void (*set)(Gl);
  gl::Reason reason;
};
const Rare kRares[] = {
    {"depth clamp", [](Gl gl) { gl.Enable(GL_DEPTH_CLAMP); }, gl::Reason::depthClamp},
    {"clip control", [](Gl gl) { gl.ClipControl(GL_UPPER_LEFT, GL_NEGATIVE_ONE_TO_ONE); },
     gl::Reason::clipControl},
    {"zero to one, with layers",
     [](Gl gl) {
       gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
       gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthMask(GL_FALSE);
     },
     gl::Reason::depthMask},
    {"first vertex provokes",
     [](Gl gl) { gl.ShadeModel(GL_FLAT), gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION); },
     gl::Reason::provokingVertex},
    {"rasteriser off", [](Gl gl) { gl.Enable(GL_RASTERIZER_DISCARD); }, gl::Reason::transformFeedback},
    {"radial fog over layers",
     [](Gl gl) {
       gl.Enable(GL_FOG), gl.Fogi(GL_FOG_DISTANCE_MODE_NV, GL_EYE_RADIAL_NV);
       gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthMask(GL_FALSE);
     },
     gl::Reason::fog},
    {"sample mask", [](Gl gl) { gl.Enable(GL_SAMPLE_MASK); }, gl::Reason::multisampleState},
};

TEST(RareState, IsRasterisedWithItsReason) {
  for (const Rare& rare : kRares) {
    const auto real = OsmesaContext::create({kQuerySize, kQuerySize});
    TracedContext ours({kQuerySize, kQuerySize});
    const auto draw = [&](Gl gl) {
      gl.Enable(GL_DEPTH_TEST), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      rare.set(gl);
      gl.Color3f(0.2f, 0.7f, 0.4f), triangle(gl, 0.2f);
      return readImage(gl, kQuerySize, kQuerySize);
    };
    EXPECT_TRUE(draw(real->real()) == draw(ours.gl())) << rare.name;
    EXPECT_EQ(ours.context().counts.statistics.rasterisedBecause[static_cast<size_t>(rare.reason)], 1u)
        << rare.name;
  }
}

}  // namespace
}  // namespace gluray::test
