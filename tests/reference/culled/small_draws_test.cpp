// Small draws that are left out as a whole: pictures are those of all draws to the bit, whatever happens
// between a look at the depths and a draw.
#include "tests/reference/culled/sampled_framebuffer.h"
#include "tests/reference/culled/small_scene.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

using Step = std::function<void(Gl, const SmallScene&)>;

gl::Statistics compareScene(
    const std::string& name, const Step& draw, const Step& prepare = [](Gl, const SmallScene&) {},
    const Settings& settings = smallDraws()) {
  SmallScene scene;
  return compareFrames(
      "small_" + name, 3, [&](Gl gl) { scene.prepare(gl), prepare(gl, scene); },
      [&](Gl gl, int) { scene.begin(gl), draw(gl, scene); }, &settings, kCompatible);
}

TEST(SmallDraws, AreLeftOutBehindAWallAndOutsideOfTheView) {
  const gl::Statistics hidden = compareScene("hidden", [](Gl gl, const SmallScene& s) {
    s.wallSeen(gl);
    s.balls(gl, 6), s.balls(gl, 3.2f);
  });
  // In three frames: the ball after the wall, and those of the row that lie behind it.
  EXPECT_EQ(hidden.drawsCulled, 3 * 8u);
  EXPECT_EQ(hidden.trianglesLeftOut, hidden.drawsCulled * ball(10).triangles());
  const gl::Statistics outside = compareScene("outside", [](Gl gl, const SmallScene& s) {
    s.balls(gl, 3, 12), s.balls(gl, 3), s.ballAt(gl, {0, 0, 3}), s.ballAt(gl, {0, 0, -30});
  });
  EXPECT_GE(outside.drawsCulled, 3 * 9u);
}

TEST(SmallDraws, AreWholeBeforeTheWall) {
  const gl::Statistics back =
      compareScene("back_to_front", [](Gl gl, const SmallScene& s) { s.balls(gl, 6), s.wallSeen(gl); });
  EXPECT_EQ(back.drawsCulled, 3u);
}

/// What happens between the look and the balls, which the wall would hide.
struct Between {
  std::string name;
  Step step;
  Step prepare = [](Gl, const SmallScene&) {};
};

void farWall(Gl gl, const SmallScene& s, GLenum func) {
  gl.DepthFunc(func), s.board(gl, 9, 4), gl.DepthFunc(GL_LESS);
}

std::vector<Between> changesOfDepths() {
  const auto pixels = [](Gl gl, const SmallScene&) {
    const std::vector<GLfloat> far(size_t{kSide} * kSide, 1.0f);
    gl.UseProgram(0), gl.DepthFunc(GL_ALWAYS), gl.WindowPos2i(0, 0);
    gl.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl.DrawPixels(kSide, kSide, GL_DEPTH_COMPONENT, GL_FLOAT, far.data());
    gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE), gl.DepthFunc(GL_LESS);
  };
  const auto copied = [](Gl gl, const SmallScene&) {
    gl.UseProgram(0), gl.DepthFunc(GL_ALWAYS), gl.WindowPos2i(0, 40);
    gl.CopyPixels(0, 0, kSide, 40, GL_DEPTH), gl.DepthFunc(GL_LESS);
  };
  const auto immediate = [](Gl gl, const SmallScene&) {
    gl.UseProgram(0), gl.DepthFunc(GL_ALWAYS);
    gl.Begin(GL_QUADS);
    gl.Vertex3f(-1, -1, 0.99f), gl.Vertex3f(1, -1, 0.99f), gl.Vertex3f(1, 1, 0.99f),
        gl.Vertex3f(-1, 1, 0.99f);
    gl.End();
    gl.DepthFunc(GL_LESS);
  };
  return {
      {"clear", [](Gl gl, const SmallScene&) { gl.Clear(GL_DEPTH_BUFFER_BIT); }},
      {"clear_part",
       [](Gl gl, const SmallScene&) {
         gl.Enable(GL_SCISSOR_TEST), gl.Scissor(60, 60, 50, 70);
         gl.Clear(GL_DEPTH_BUFFER_BIT), gl.Disable(GL_SCISSOR_TEST);
       }},
      {"clear_buffer",
       [](Gl gl, const SmallScene&) {
         const GLfloat far = 1;
         gl.ClearBufferfv(GL_DEPTH, 0, &far);
       }},
      {"always", [](Gl gl, const SmallScene& s) { farWall(gl, s, GL_ALWAYS); }},
      {"not_equal", [](Gl gl, const SmallScene& s) { farWall(gl, s, GL_NOTEQUAL); }},
      {"greater", [](Gl gl, const SmallScene& s) { farWall(gl, s, GL_GREATER); }},
      {"draw_pixels", pixels},
      {"copy_pixels", copied},
      {"immediate", immediate},
      {"list", [](Gl gl, const SmallScene&) { gl.CallList(77); },
       [](Gl gl, const SmallScene&) {
         gl.NewList(77, GL_COMPILE), gl.Clear(GL_DEPTH_BUFFER_BIT), gl.EndList();
       }},
  };
}

TEST(SmallDraws, SeeThatDepthsWerePushedBack) {
  for (const Between& of : changesOfDepths()) {
    const gl::Statistics counts = compareScene(
        of.name,
        [&](Gl gl, const SmallScene& s) {
          s.wallSeen(gl), of.step(gl, s);
          gl.UseProgram(s.program), s.balls(gl, 6);
        },
        of.prepare);
    EXPECT_GE(counts.drawsCulled, 3u) << of.name << ": the ball before the change";
  }
}

TEST(SmallDraws, AreStillLeftOutAfterDrawsThatOnlyComeNearer) {
  const gl::Statistics counts = compareScene("nearer", [](Gl gl, const SmallScene& s) {
    s.wallSeen(gl);
    gl.DepthFunc(GL_LEQUAL), s.wall(gl, 4.5f);
    gl.DepthFunc(GL_EQUAL), s.wall(gl, 4);
    gl.DepthFunc(GL_ALWAYS), gl.DepthMask(GL_FALSE), s.wall(gl, 4, 0.5f), gl.DepthMask(GL_TRUE);
    gl.DepthFunc(GL_LESS), s.balls(gl, 6);
  });
  EXPECT_GT(counts.drawsCulled, 3 * 5u);
}

/// State of the balls, which lie behind the wall.
std::vector<Between> states() {
  const auto range = [](double near, double far) {
    return [=](Gl gl, const SmallScene& s) { gl.DepthRange(near, far), s.balls(gl, 6), gl.DepthRange(0, 1); };
  };
  return {
      {"depth_range", range(0, 0.5)},
      {"depth_range_turned", range(1, 0)},
      {"always",
       [](Gl gl, const SmallScene& s) { gl.DepthFunc(GL_ALWAYS), s.balls(gl, 6), gl.DepthFunc(GL_LESS); }},
      {"greater",
       [](Gl gl, const SmallScene& s) { gl.DepthFunc(GL_GREATER), s.balls(gl, 6), gl.DepthFunc(GL_LESS); }},
      {"no_test",
       [](Gl gl, const SmallScene& s) {
         gl.Disable(GL_DEPTH_TEST), s.balls(gl, 6), gl.Enable(GL_DEPTH_TEST);
       }},
      {"viewport",
       [](Gl gl, const SmallScene& s) {
         gl.Viewport(-90, -40, 3 * kSide, 2 * kSide), s.balls(gl, 6), gl.Viewport(0, 0, kSide, kSide);
         gl.Viewport(100, 20, 90, 120), s.balls(gl, 6), gl.Viewport(0, 0, kSide, kSide);
       }},
      {"scissor",
       [](Gl gl, const SmallScene& s) {
         gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 70, kSide, 60), s.balls(gl, 6);
         gl.Disable(GL_SCISSOR_TEST);
       }},
      {"offset",
       [](Gl gl, const SmallScene& s) {
         gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(-200, -2e6f), s.balls(gl, 6);
         gl.Disable(GL_POLYGON_OFFSET_FILL);
       }},
      {"lines",
       [](Gl gl, const SmallScene& s) {
         gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), gl.LineWidth(9), s.balls(gl, 6, 1.4f);
         gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL), gl.LineWidth(1);
       }},
      {"clamp",
       [](Gl gl, const SmallScene& s) {
         gl.Enable(GL_DEPTH_CLAMP), s.ballAt(gl, {0.2f, 0, -0.3f}), s.ballAt(gl, {0.2f, 2, -21}, 3);
         gl.Disable(GL_DEPTH_CLAMP);
       }},
      {"stencil",
       [](Gl gl, const SmallScene& s) {
         gl.Clear(GL_STENCIL_BUFFER_BIT), gl.Enable(GL_STENCIL_TEST);
         gl.StencilFunc(GL_ALWAYS, 1, 255), gl.StencilOp(GL_KEEP, GL_INCR, GL_KEEP), s.balls(gl, 6);
         gl.StencilFunc(GL_LESS, 0, 255), gl.StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
         gl.DepthFunc(GL_ALWAYS), s.wall(gl, 5, 3), gl.DepthFunc(GL_LESS), gl.Disable(GL_STENCIL_TEST);
       }},
      {"near_plane",
       [](Gl gl, const SmallScene& s) {
         s.ballAt(gl, {0.3f, 0.2f, -6}, 6.2f), s.ballAt(gl, {0, 0, -1}, 1.2f), s.ballAt(gl, {0, 0, 4}, 0.5f);
       }},
  };
}

TEST(SmallDraws, FollowTheStateOfEachDraw) {
  for (const Between& of : states()) {
    const gl::Statistics counts =
        compareScene("state_" + of.name, [&](Gl gl, const SmallScene& s) { s.wallSeen(gl), of.step(gl, s); });
    EXPECT_GE(counts.drawsCulled, 3u) << of.name;
  }
}

TEST(SmallDraws, AreLeftOutWhateverTheyWouldWrite) {
  const gl::Statistics counts = compareScene("blended", [](Gl gl, const SmallScene& s) {
    s.wallSeen(gl);
    gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthMask(GL_FALSE);
    s.balls(gl, 6), s.balls(gl, 3.2f);
    gl.DepthMask(GL_TRUE), gl.Disable(GL_BLEND);
  });
  EXPECT_EQ(counts.drawsCulled, 3 * 8u);
}

TEST(SmallDraws, KeepWhatQueriesAndFeedbackCount) {
  SmallScene scene;
  GLuint query = 0, feedback = 0;
  std::vector<GLuint> counted;
  const Settings settings = smallDraws();
  compareFrames(
      "small_counted", 2,
      [&](Gl gl) {
        scene.prepare(gl);
        const char* const names[] = {"gl_Position"};
        gl.TransformFeedbackVaryings(scene.program, 1, names, GL_INTERLEAVED_ATTRIBS);
        gl.LinkProgram(scene.program);
        gl.GenQueries(1, &query), gl.GenBuffers(1, &feedback);
        gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, feedback);
        gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 1 << 20, nullptr, GL_STREAM_COPY);
      },
      [&](Gl gl, int) {
        scene.begin(gl), scene.wallSeen(gl);
        gl.BeginQuery(GL_PRIMITIVES_GENERATED, query), scene.balls(gl, 6),
            gl.EndQuery(GL_PRIMITIVES_GENERATED);
        GLuint primitives = 0;
        gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &primitives);
        counted.push_back(primitives);
        gl.BufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 4, &primitives);
        gl.BeginTransformFeedback(GL_TRIANGLES), scene.ballAt(gl, {0, 0, -6}), gl.EndTransformFeedback();
        GLfloat kept = 0;
        gl.GetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 12, 4, &kept);
        counted.push_back(kept > 5.5f && kept < 6.5f ? 1 : 0);
      },
      &settings, kCompatible);
  ASSERT_EQ(counted.size(), 8u);
  for (size_t i = 0; i < 8; i += 2) EXPECT_EQ(counted[i], 7 * ball(10).triangles()) << i;
  for (size_t i = 1; i < 8; i += 2) EXPECT_EQ(counted[i], 1u) << "the vertex at w = 6 was kept";
}

TEST(SmallDraws, FollowVerticesAndPlacesThatMove) {
  SmallScene scene;
  const Settings settings = smallDraws();
  const gl::Statistics counts = compareFrames(
      "small_moving", 5, [&](Gl gl) { scene.prepare(gl); },
      [&](Gl gl, int frame) {
        scene.begin(gl), scene.wallSeen(gl);
        std::vector<glm::vec3> moved = scene.ballMesh().positions;
        for (glm::vec3& p : moved) p.z += 3.0f * static_cast<float>(frame % 3);
        gl.BindBuffer(GL_ARRAY_BUFFER, scene.ballPositions());
        gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(moved.size() * sizeof(glm::vec3)),
                         moved.data());
        scene.balls(gl, 5.5f), scene.ballAt(gl, {0.3f, 0.3f, -6 + static_cast<float>(frame)});
      },
      &settings, kCompatible);
  EXPECT_GT(counts.drawsCulled, 10u);
}

TEST(SmallDraws, OfProgramsThatMoveVerticesOrDepthsAreWhole) {
  const std::string waves =
      replacedIn(kCulledVertex, "gl_Position = clipFromEye * eye;",
                 "gl_Position = clipFromEye * eye;\n  gl_Position.z -= 0.6 * abs(sin(position.x)) * eye.z;");
  const std::string near =
      replacedIn(kCulledFragment, "color = vec4(light", "gl_FragDepth = 0.1;\n  color = vec4(light");
  const std::string copies = replacedIn(kCulledVertex, "vec4 eye = eyeFromObject * vec4(position, 1.0);",
                                        "vec4 eye = eyeFromObject * vec4(position, 1.0);\n"
                                        "  eye.z += 2.5 * float(gl_InstanceID);");
  const auto compare = [](const std::string& name, const std::string& vertex, const std::string& fragment) {
    SmallScene scene;
    const Settings settings = smallDraws();
    return compareFrames(
        "small_" + name, 2, [&](Gl gl) { scene.prepare(gl, vertex, fragment); },
        [&](Gl gl, int) {
          scene.begin(gl), scene.wallSeen(gl), scene.balls(gl, 6);
          gl.BindVertexArray(scene.ballArray());
          gl.DrawElementsInstanced(GL_TRIANGLES, scene.ballMesh().count(), GL_UNSIGNED_INT, nullptr, 3);
        },
        &settings, kCompatible);
  };
  EXPECT_EQ(compare("waves", waves, kCulledFragment).drawsCulled, 0u);
  EXPECT_EQ(compare("depth", kCulledVertex, near).drawsCulled, 0u);
  EXPECT_EQ(compare("copies", copies, kCulledFragment).drawsCulled, 0u);
}

TEST(SmallDraws, ByFixedFunctionAreLeftOut) {
  const ProgramMesh mesh = ball(12);
  const std::vector<GLuint> indices(mesh.indices.begin(), mesh.indices.end());
  const Settings settings = smallDraws();
  const gl::Statistics counts = compareFrames(
      "small_fixed", 3, [](Gl) {},
      [&](Gl gl, int frame) {
        drawByFixedFunction(gl, mesh, frame, GL_TRIANGLES, indices);
        gl.Disable(GL_POLYGON_STIPPLE);  // it leaves holes
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, mesh.indices.data());
        for (int i = 1; i < 12; ++i) {
          gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity(), gl.Translatef(0.02f * i, 0, -4 - 0.8f * i);
          gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, mesh.indices.data());
        }
      },
      &settings, {kSide, kSide, false, 2, 1});
  EXPECT_GT(counts.drawsCulled, 6u);
}

TEST(SmallDraws, AreLeftOutOfMultisampledFramebuffers) {
  SmallScene scene;
  const Settings settings = smallDraws();
  const gl::Statistics counts = compareSamples(
      "small_multisampled", 3, 4, GL_DEPTH24_STENCIL8, [&](Gl gl) { scene.prepare(gl); },
      [&](Gl gl, int) { scene.begin(gl), scene.wallSeen(gl), scene.balls(gl, 6), scene.balls(gl, 3.2f); },
      &settings);
  EXPECT_GT(counts.drawsCulled, 3 * 4u);
}

TEST(SmallDraws, ThatAreVerifiedAreMadeAndCounted) {
  Settings settings = smallDraws();
  settings.cull.verify = 1;
  const gl::Statistics counts = compareScene(
      "verified", [](Gl gl, const SmallScene& s) { s.wallSeen(gl), s.balls(gl, 6); },
      [](Gl, const SmallScene&) {}, settings);
  EXPECT_EQ(counts.drawsCulled, 3 * 8u);
}

TEST(SmallDraws, AreMadeWhereTheSettingIsOff) {
  const gl::Statistics counts = compareScene(
      "off", [](Gl gl, const SmallScene& s) { s.wallSeen(gl), s.balls(gl, 6); }, [](Gl, const SmallScene&) {},
      smallDraws(Culling::off));
  EXPECT_EQ(counts.drawsCulled, 0u);
}

}  // namespace
}  // namespace gluray::test
