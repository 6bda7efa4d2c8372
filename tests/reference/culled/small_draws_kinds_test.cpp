// Small draws that are left out, of several kinds of programs, framebuffers and settings; and what must be
// made because something counts or keeps it.
#include "tests/reference/culled/sampled_framebuffer.h"
#include "tests/reference/culled/small_scene.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

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
        gl.Disable(GL_POLYGON_STIPPLE);                              // it leaves holes
        gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(0, -1);  // not traced under GL_GEQUAL
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, mesh.indices.data());
        for (int i = 1; i < 12; ++i) {
          gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity(), gl.Translatef(0.02f * i, 0, -4 - 0.8f * i);
          gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, mesh.indices.data());
        }
        gl.Disable(GL_POLYGON_OFFSET_FILL);
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
