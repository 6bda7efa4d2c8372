// Culled draws in multisampled framebuffers: all samples are those of whole draws to the bit.
#include "tests/reference/culled/culled_programs.h"
#include "tests/reference/culled/sampled_framebuffer.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using namespace culled;

struct Case {
  std::string name;
  std::string fragment = kCulledFragment;
  std::function<void(Gl)> state = [](Gl) {};
  int samples = 4;
  GLenum depth = GL_DEPTH24_STENCIL8;
  std::string vertex = kCulledVertex;
  ProgramMesh mesh = shells(5, 100);
};

gl::Statistics compareCase(const Case& of, const Settings* settings = nullptr, int draws = 1) {
  GLuint program = 0, array = 0;
  const ProgramMesh& mesh = of.mesh;
  return compareSamples(
      "multisampled_" + of.name, 4, of.samples, of.depth,
      [&](Gl gl) {
        program = makeProgram(gl, of.vertex, of.fragment);
        array = send(gl, mesh, program).array;
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program), gl.BindVertexArray(array);
        of.state(gl);
        for (int i = 0; i < draws; ++i) {
          turn(gl, program, frame + 3 * i);
          gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
        }
      },
      settings);
}

TEST(CulledSamples, AreThoseOfWholeDraws) {
  for (const Case& of :
       {Case{"plain"}, Case{.name = "within", .state = [](Gl gl) { gl.Viewport(30, 50, 90, 80); }},
        Case{.name = "two", .samples = 2}, Case{.name = "24", .depth = GL_DEPTH_COMPONENT24},
        Case{.name = "floats", .depth = GL_DEPTH_COMPONENT32F},
        Case{.name = "16", .depth = GL_DEPTH_COMPONENT16},
        Case{.name = "or_equal", .state = [](Gl gl) { gl.DepthFunc(GL_LEQUAL); }},
        Case{.name = "scissored", .state = [](Gl gl) {
               gl.Enable(GL_SCISSOR_TEST), gl.Scissor(30, 50, 90, 80), gl.Viewport(-20, 10, 240, 170);
             }}}) {
    const gl::Statistics counts = compareCase(of);
    EXPECT_EQ(counts.drawsCulled, 3u) << of.name;
    EXPECT_GT(counts.trianglesLeftOut, 3 * 5 * 100 * 100u) << of.name;
  }
}

/// Positions come by feedback.
TEST(CulledSamples, OfVerticesThatAreDisplaced) {
  const std::string vertex = replacedIn(kCulledVertex, "vec4(position, 1.0)",
                                        "vec4(position * (1.0 + 0.1 * sin(9.0 * position.y)), 1.0)");
  EXPECT_EQ(compareCase({.name = "displaced", .vertex = vertex}).drawsCulled, 3u);
}

TEST(CulledSamples, KeepDiscardedFragmentsAndDerivatives) {
  const std::string holes = replacedIn(kCulledFragment, "vec3 light = vec3(0.1);",
                                       "if (fract(6.0 * place.x) < 0.5) discard;\n"
                                       "  vec3 light = vec3(0.1) + 3.0 * fwidth(place);");
  EXPECT_GT(compareCase({"holes", holes}).drawsCulled, 0u);
}

/// A shader that runs for each sample.
TEST(CulledSamples, OfShadersThatRunForEachSample) {
  std::string each =
      replacedIn(kCulledFragment, "#version 150", "#version 150\n#extension GL_ARB_sample_shading : require");
  each = replacedIn(each, "vec3 light = vec3(0.1);", "vec3 light = vec3(0.1 + 0.2 * float(gl_SampleID));");
  EXPECT_GT(compareCase({"each", each}).drawsCulled, 0u);
}

TEST(CulledSamples, ByFixedFunction) {
  const ProgramMesh mesh = shells(5, 60);
  for (const int verify : {0, 1}) {
    Settings settings = culling(Culling::always);
    settings.cull.verify = verify;
    const auto draw = [&](Gl gl, int frame) {
      gl.UseProgram(0), gl.BindVertexArray(0);
      drawByFixedFunction(gl, mesh, frame, GL_TRIANGLES, mesh.indices);
    };
    const gl::Statistics counts = compareSamples("multisampled_fixed", 4, 4, GL_DEPTH24_STENCIL8, [](Gl) {},
                                                 draw, &settings, {kSide, kSide});
    EXPECT_EQ(counts.drawsCulled, 3u);
  }
}

TEST(CulledSamples, AreVerified) {
  Settings settings = culling(Culling::always);
  settings.cull.verify = 1;
  EXPECT_GT(compareCase({"verified"}, &settings).drawsCulled, 0u);
}

/// What the first draw has left cannot be put back.
TEST(CulledSamples, AboveOtherDraws) {
  EXPECT_EQ(compareCase({"above"}, nullptr, 2).drawsCulled, 7u);
  EXPECT_EQ(compareCase({.name = "above_floats", .depth = GL_DEPTH_COMPONENT32F}, nullptr, 2).drawsCulled,
            7u);
  EXPECT_EQ(compareCase({.name = "above_16", .depth = GL_DEPTH_COMPONENT16}, nullptr, 2).drawsCulled, 7u);
  Settings settings = culling(Culling::always);
  settings.cull.verify = 1;
  EXPECT_EQ(compareCase({"above_verified"}, &settings, 2).drawsCulled, 7u);
}

TEST(CulledSamples, WhereLargerDepthsAreNearer) {
  for (const GLenum function : {GL_GREATER, GL_GEQUAL}) {
    const auto reversed = [&](Gl gl) {
      gl.ClearDepth(0), gl.Clear(GL_DEPTH_BUFFER_BIT);
      gl.DepthRange(1, 0), gl.DepthFunc(function);
    };
    EXPECT_GT(compareCase({"reversed", kCulledFragment, reversed}).drawsCulled, 0u);
  }
}

/// Each triangle twice, in other colours: which one shows depends on the order.
TEST(CulledSamples, KeepTheOrderOfEqualDepths) {
  const std::string numbered =
      replacedIn(kCulledVertex, "place = position;", "place = position + float(gl_VertexID % 7);");
  for (const GLenum function : {GL_LESS, GL_LEQUAL})
    for (const bool above : {false, true}) {
      const auto state = [&](Gl gl) {
        gl.DepthFunc(function);
        if (!above) return;  // a clear with the scissor test does not clear all
        gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, 50, 50), gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.Disable(GL_SCISSOR_TEST);
      };
      Case of{"twice", kCulledFragment, state};
      of.vertex = numbered, of.mesh = twice(shells(5, 60));
      EXPECT_GT(compareCase(of).drawsCulled, 0u);
    }
}

TEST(CulledSamples, AreNotMadeWhereTheyWouldNotBeExact) {
  const auto refused = [](const Case& of) { EXPECT_EQ(compareCase(of).drawsCulled, 0u) << of.name; };
  refused({"without", kCulledFragment, [](Gl gl) { gl.Disable(GL_MULTISAMPLE); }});
  refused({"coverage", kCulledFragment, [](Gl gl) { gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE); }});
  const std::string centroids =
      replacedIn(kCulledFragment, "in vec3 place, n;", "centroid in vec3 place, n;");
  refused({"centroids", centroids});
  refused({"mask", kCulledFragment, [](Gl gl) { gl.Enable(GL_SAMPLE_MASK), gl.SampleMaski(0, 5); }});
}

}  // namespace
}  // namespace gluray::test
