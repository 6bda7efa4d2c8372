// Draws of any shader program, made without what cannot be seen: images are those of whole draws to the
// bit.
#include "tests/reference/culled/turned_draws.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>

namespace gluray::test {
namespace {

using namespace culled;

void drawAll(Gl gl, const ProgramMesh& mesh) {
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

TEST(CulledDraws, AreTheSameWhileTheCameraTurns) {
  const ProgramMesh mesh = shells(6, 120);
  const gl::Statistics counts = compareTurned("turns", 6, mesh, [&](Gl gl) { drawAll(gl, mesh); });
  EXPECT_EQ(counts.drawsCulled, 5u);
  EXPECT_GT(counts.trianglesLeftOut, 5 * mesh.triangles() / 2);
}

/// Draws the shells in each frame, by `draw`, after `prepare`.
gl::Statistics compareShells(
    const std::string& name, const std::string& fragment,
    const std::function<void(Gl, const ProgramMesh&)>& draw,
    const std::function<void(Gl)>& prepare = [](Gl) {}, const Settings* settings = nullptr) {
  const ProgramMesh mesh = shells(5, 100);
  return compareTurned(name, 4, mesh, [&](Gl gl) { draw(gl, mesh); },
                       {kCulledVertex, fragment, prepare, settings});
}

TEST(CulledDraws, KeepDiscardedFragmentsAndDerivatives) {
  const std::string holes = replacedIn(kCulledFragment, "vec3 light = vec3(0.1);",
                                       "if (fract(6.0 * place.x) < 0.5) discard;\n"
                                       "  vec3 light = vec3(0.1) + 3.0 * fwidth(place);");
  EXPECT_GT(compareShells("holes", holes, drawAll).drawsCulled, 0u);
}

TEST(CulledDraws, OfAllForms) {
  const auto lessOrEqual = [](Gl gl, const ProgramMesh& mesh) {
    gl.DepthFunc(GL_LEQUAL);
    gl.DrawRangeElements(GL_TRIANGLES, 0, static_cast<GLuint>(mesh.positions.size()) - 1, mesh.count(),
                         GL_UNSIGNED_INT, nullptr);
  };
  EXPECT_GT(compareShells("less_or_equal", kCulledFragment, lessOrEqual).drawsCulled, 0u);
  // The shells after the first one, by a number that is added to the first one's indices.
  const auto base = [](Gl gl, const ProgramMesh& mesh) {
    const auto vertices = static_cast<GLint>(mesh.positions.size() / 5);
    for (GLint k = 0; k < 5; ++k)
      gl.DrawElementsBaseVertex(GL_TRIANGLES, mesh.count() / 5, GL_UNSIGNED_INT, nullptr, k * vertices);
  };
  EXPECT_GT(compareShells("base_vertex", kCulledFragment, base).drawsCulled, 0u);
  const auto strips = [](Gl gl, const ProgramMesh& mesh) {
    gl.DrawElements(GL_TRIANGLE_STRIP, mesh.count(), GL_UNSIGNED_INT, nullptr);
  };
  EXPECT_GT(compareShells("strip", kCulledFragment, strips).drawsCulled, 0u);
  const auto inOrder = [](Gl gl, const ProgramMesh& mesh) {
    gl.DrawArrays(GL_TRIANGLES, 3, static_cast<GLsizei>(mesh.positions.size() / 3 * 3 - 3));
  };
  EXPECT_GT(compareShells("in_order", kCulledFragment, inOrder).drawsCulled, 0u);
  const auto scissored = [](Gl gl, const ProgramMesh& mesh) {
    gl.Enable(GL_SCISSOR_TEST), gl.Scissor(30, 50, 90, 80);
    gl.Viewport(-20, 10, 240, 170);
    drawAll(gl, mesh);
    gl.Disable(GL_SCISSOR_TEST);
  };
  EXPECT_GT(compareShells("scissored", kCulledFragment, scissored).drawsCulled, 0u);
  const auto ranged = [](Gl gl, const ProgramMesh& mesh) {
    gl.DepthRange(0.9, 0.2), gl.ClearDepth(1);
    drawAll(gl, mesh);
    gl.DepthRange(0, 1);
  };
  EXPECT_GT(compareShells("depth_range", kCulledFragment, ranged).drawsCulled, 0u);
}

/// Each triangle twice, in other colours: which one shows depends on the order.
TEST(CulledDraws, KeepTheOrderOfEqualDepths) {
  const std::string numbered =
      replacedIn(kCulledVertex, "place = position;", "place = position + float(gl_VertexID % 7);");
  for (const GLenum function : {GL_LESS, GL_LEQUAL}) {
    GLuint program = 0;
    const ProgramMesh mesh = twice(shells(5, 60));
    compareFrames(
        "twice", 5,
        [&](Gl gl) {
          program = makeProgram(gl, numbered, kCulledFragment);
          send(gl, mesh, program);
        },
        [&](Gl gl, int frame) {
          clear(gl);
          gl.DepthFunc(function);
          gl.UseProgram(program);
          turn(gl, program, frame);
          drawAll(gl, mesh);
        });
  }
}

TEST(CulledDraws, WhereLargerDepthsAreNearer) {
  for (const GLenum function : {GL_GREATER, GL_GEQUAL}) {
    const auto reversed = [&](Gl gl, const ProgramMesh& mesh) {
      gl.ClearDepth(0), gl.Clear(GL_DEPTH_BUFFER_BIT);
      gl.DepthRange(1, 0), gl.DepthFunc(function);
      drawAll(gl, mesh);
      gl.DepthRange(0, 1);
    };
    EXPECT_GT(compareShells("reversed", kCulledFragment, reversed).drawsCulled, 0u);
    // The inside is seen.
    const auto farthest = [&](Gl gl, const ProgramMesh& mesh) {
      gl.ClearDepth(0), gl.Clear(GL_DEPTH_BUFFER_BIT);
      gl.DepthFunc(function);
      drawAll(gl, mesh);
    };
    EXPECT_GT(compareShells("farthest", kCulledFragment, farthest).drawsCulled, 0u);
  }
}

void blend(Gl gl) { gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); }

TEST(CulledDraws, ThatBlendWithAnAlphaOfOne) {
  EXPECT_GT(compareShells("opaque", kCulledFragment, drawAll, blend).drawsCulled, 0u);
  const std::string returned =
      replacedIn(replacedIn(kCulledFragment, "void main() {",
                            "vec4 solid(vec3 c) { return vec4(c, 1.0); }\nvoid main() {"),
                 "color = vec4(light * mix(vec3(0.5, 0.3, 0.1), vec3(1.0, 0.8, 0.5), wood(place)), 1.0);",
                 "if (place.x > 0.3) discard;\n  color = solid(light);");
  EXPECT_GT(compareShells("returned", returned, drawAll, blend).drawsCulled, 0u);
  for (const char* const alpha : {"0.5);", "min(1.0, 40.0 * n.x));", "place.x > 0.0 ? 1.0 : 0.5);"}) {
    const std::string clear = replacedIn(kCulledFragment, "1.0);\n}", std::string(alpha) + "\n}");
    EXPECT_EQ(compareShells("clear", clear, drawAll, blend).drawsCulled, 0u) << alpha;
  }
}

TEST(CulledDraws, ByFixedFunctionFromTheProgramsMemory) {
  const ProgramMesh mesh = shells(5, 60);
  std::vector<GLuint> quads;
  for (size_t i = 0; i < mesh.indices.size(); i += 3)
    for (const size_t corner : {i, i + 1, i + 2, i + 2}) quads.push_back(mesh.indices[corner]);
  const auto culled = [&](const char* name, GLenum mode, const std::vector<GLuint>& indices) {
    const auto draw = [&](Gl gl, int frame) { drawByFixedFunction(gl, mesh, frame, mode, indices); };
    return compareFrames(name, 4, [](Gl) {}, draw, nullptr, {kSide, kSide}).drawsCulled;
  };
  EXPECT_GT(culled("fixed_triangles", GL_TRIANGLES, mesh.indices), 0u);
  EXPECT_GT(culled("fixed_quads", GL_QUADS, quads), 0u);
  EXPECT_EQ(culled("fixed_polygon", GL_QUAD_STRIP, mesh.indices), 0u);
}

TEST(CulledDraws, AreNotMadeWhereTheyWouldNotBeExact) {
  const std::string deep = replacedIn(kCulledFragment, "void main() {",
                                      "void main() {\n  gl_FragDepth = fract(3.0 * gl_FragCoord.z);");
  EXPECT_EQ(compareShells("deep", deep, drawAll).drawsCulled, 0u);
  const std::string numbers = replacedIn(kCulledFragment, "wood(place)", "float(gl_PrimitiveID % 5) / 4.0");
  EXPECT_EQ(compareShells("numbers", numbers, drawAll).drawsCulled, 0u);
  // Discarded fragments write depth.
  const std::string discards = replacedIn(kCulledFragment, "void main() {",
                                          "void main() {\n  if (fract(6.0 * place.x) < 0.5) discard;");
  const std::string early =
      replacedIn(discards, "#version 150\n", "#version 420\nlayout(early_fragment_tests) in;\n");
  EXPECT_GT(compareShells("discards", discards, drawAll).drawsCulled, 0u);
  EXPECT_EQ(compareShells("early", early, drawAll).drawsCulled, 0u);
}

/// Programs need their shaders no longer once they are linked.
TEST(CulledDraws, ByProgramsWhoseShadersAreGone) {
  const auto detach = [](Gl gl) {
    GLuint name = 1;
    while (!gl.IsProgram(name)) ++name;
    std::array<GLuint, 4> shaders{};
    GLsizei count = 0;
    gl.GetAttachedShaders(name, 4, &count, shaders.data());
    EXPECT_EQ(count, 2);
    for (GLsizei i = 0; i < count; ++i)
      gl.DetachShader(name, shaders[static_cast<size_t>(i)]);  // it was deleted before
    gl.GetAttachedShaders(name, 4, &count, shaders.data());
    EXPECT_EQ(count, 0);
  };
  EXPECT_GT(compareShells("detached", kCulledFragment, drawAll, detach).drawsCulled, 0u);
}

TEST(CulledDraws, KeepTheErrorsOfThePrograms) {
  for (const Culling how : {Culling::off, Culling::always}) {
    TracedContext context({kSide, kSide, true, 3, 2}, culling(how));
    Gl gl = context.gl();
    const ProgramMesh mesh = shells(5, 60);
    const GLuint program = makeProgram(gl, kCulledVertex, kCulledFragment);
    send(gl, mesh, program);
    for (int frame = 0; frame < 3; ++frame) {
      clear(gl);
      gl.UseProgram(program);
      turn(gl, program, frame);
      gl.Enable(GL_TEXTURE_MIN_FILTER);  // names nothing that can be enabled
      drawAll(gl, mesh);
      EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << frame;
      gl.DrawElements(GL_QUADS, mesh.count() / 4 * 4, GL_UNSIGNED_INT, nullptr);  // not in a core profile
      EXPECT_NE(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR)) << frame;
      EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR)) << frame;
    }
    EXPECT_EQ(context.context().counts.statistics.drawsCulled > 0, how == Culling::always);
  }
}

TEST(CulledDraws, AreVerified) {
  Settings settings = culling(Culling::always);
  settings.cull.verify = 1;
  EXPECT_GT(compareShells(
                "verified", kCulledFragment, drawAll, [](Gl) {}, &settings)
                .drawsCulled,
            0u);
}

}  // namespace
}  // namespace gluray::test
