// Culled draws whose positions are no matrix times an attribute: the real OpenGL feeds them back.
#include "tests/reference/culled/culled_frames.h"
#include "tests/reference/culled/culled_programs.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

/// A vertex shader that moves vertices: `declarations`, and what `at` is, a vec3 from position and normal.
std::string moving(const std::string& declarations, const std::string& at) {
  return replacedIn(replacedIn(kCulledVertex, "vec4(position, 1.0)", "vec4(at, 1.0)"), "void main() {",
                    declarations + "\nvoid main() {\n  vec3 at = " + at + ";");
}

struct FedScene {
  std::string vertex, fragment = kCulledFragment;
  std::function<void(Gl, GLuint program)> prepare = [](Gl, GLuint) {};
  std::function<void(Gl, GLuint program, int frame)> before = [](Gl, GLuint, int) {};
  std::function<void(Gl, const ProgramMesh&)> draw = [](Gl gl, const ProgramMesh& mesh) {
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  };
  ContextWish wish = {kSide, kSide, true, 3, 2};
};

gl::Statistics compare(const std::string& name, const FedScene& scene) {
  GLuint program = 0;
  const ProgramMesh mesh = shells(5, 100);
  return compareFrames(
      name, 5,
      [&](Gl gl) {
        program = makeProgram(gl, scene.vertex, scene.fragment);
        send(gl, mesh, program);
        gl.UseProgram(program);
        scene.prepare(gl, program);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program);
        turn(gl, program, frame);
        scene.before(gl, program, frame);
        scene.draw(gl, mesh);
      },
      nullptr, scene.wish);
}

const std::string kWaves =
    moving("uniform float time;", "position * (1.0 + 0.1 * sin(9.0 * position.y + time))");

void setTime(Gl gl, GLuint program, int frame) {
  gl.Uniform1f(gl.GetUniformLocation(program, "time"), 0.7f * static_cast<float>(frame));
}

TEST(FeedbackDraws, OfVerticesThatMove) {
  FedScene scene{kWaves};
  scene.before = setTime;
  const gl::Statistics counts = compare("waves", scene);
  EXPECT_EQ(counts.drawsCulled, 4u);
  EXPECT_GT(counts.trianglesLeftOut, 4 * shells(5, 100).triangles() / 3);
}

TEST(FeedbackDraws, OfAllThatAShaderComputes) {
  const std::pair<const char*, std::string> shaders[] = {
      {"branches", moving("", "position.y > 0.3 ? position : position * 0.9 + 0.05 * normal")},
      {"numbers", moving("", "position * (1.0 + 0.002 * float(gl_VertexID % 16))")},
      {"noise",
       moving("float random(vec3 p) { return fract(sin(dot(p, vec3(12.9, 78.2, 37.7))) * 43758.5); }",
              "position + 0.02 * random(position) * normal")},
      {"loops",
       moving("uniform vec3 bends[4];",
              "position; for (int i = 0; i < 4; ++i) at += 0.05 * sin(7.0 * dot(at, bends[i])) * normal")},
      {"divided", replacedIn(kCulledVertex, "gl_Position = clipFromEye * eye;",
                             "gl_Position = clipFromEye * eye; gl_Position /= gl_Position.w;")},
      {"behind", moving("", "position * 3.0 * (1.0 + 0.1 * normal.x * normal.y)")},
  };
  for (const auto& [name, vertex] : shaders) {
    FedScene scene{vertex};
    scene.before = [](Gl gl, GLuint program, int frame) {
      const float f = static_cast<float>(frame);
      const std::array<GLfloat, 12> bends{1, 0, f, 0, 1, 0, 0.5f, 0, 1, f, 0, 0};
      gl.Uniform3fv(gl.GetUniformLocation(program, "bends"), 4, bends.data());
      gl.GetError();
    };
    EXPECT_GT(compare(name, scene).drawsCulled, 0u) << name;
  }
}

/// Bones in a uniform block, weights by an attribute.
TEST(FeedbackDraws, OfSkins) {
  const std::string vertex =
      moving("layout(std140) uniform Bones { vec4 unused; mat4 bones[2]; };",
             "mix(bones[0] * vec4(position, 1.0), bones[1] * vec4(position, 1.0), 0.5 + 0.5 * normal.y).xyz");
  FedScene scene{vertex};
  std::array<GLuint, 5> buffers{};
  scene.prepare = [&](Gl gl, GLuint) { gl.GenBuffers(5, buffers.data()); };
  scene.before = [&](Gl gl, GLuint program, int frame) {
    const float turned = 0.1f * static_cast<float>(frame);
    std::array<glm::mat4, 2> bones{glm::mat4(1), glm::rotate(glm::mat4(1), turned, glm::vec3(0, 0, 1))};
    const GLuint buffer = buffers[static_cast<size_t>(frame)];
    gl.BindBuffer(GL_UNIFORM_BUFFER, buffer);
    gl.BufferData(GL_UNIFORM_BUFFER, 16 + sizeof bones, nullptr, GL_STREAM_DRAW);
    gl.BufferSubData(GL_UNIFORM_BUFFER, 16, sizeof bones, bones.data());
    gl.BindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(3 + frame), buffer);
    gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "Bones"),
                           static_cast<GLuint>(3 + frame));
  };
  EXPECT_GT(compare("skins", scene).drawsCulled, 0u);
}

TEST(FeedbackDraws, OfHeightsFromTextures) {
  const std::string vertex = moving("uniform sampler2D heights;",
                                    "position * (1.0 + 0.2 * textureLod(heights, position.xy, 0.0).r)");
  FedScene scene{vertex};
  scene.prepare = [](Gl gl, GLuint program) {
    std::vector<GLubyte> heights(64 * 64);
    for (size_t i = 0; i < heights.size(); ++i) heights[i] = static_cast<GLubyte>(i * i / 13);
    GLuint texture = 0;
    gl.GenTextures(1, &texture), gl.ActiveTexture(GL_TEXTURE3), gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, 64, 64, 0, GL_RED, GL_UNSIGNED_BYTE, heights.data());
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl.Uniform1i(gl.GetUniformLocation(program, "heights"), 3);
  };
  scene.before = [](Gl gl, GLuint, int frame) {
    const std::vector<GLubyte> row(64, static_cast<GLubyte>(80 * frame));
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 8 * frame, 64, 1, GL_RED, GL_UNSIGNED_BYTE, row.data());
  };
  EXPECT_GT(compare("heights", scene).drawsCulled, 0u);
}

TEST(FeedbackDraws, OfAllForms) {
  const auto drawn = [](const char* name, const std::function<void(Gl, const ProgramMesh&)>& draw) {
    FedScene scene{kWaves};
    scene.before = setTime, scene.draw = draw;
    return compare(name, scene).drawsCulled;
  };
  EXPECT_GT(drawn("feedback_base",
                  [](Gl gl, const ProgramMesh& mesh) {
                    const auto vertices = static_cast<GLint>(mesh.positions.size() / 5);
                    for (GLint k = 0; k < 5; ++k)
                      gl.DrawElementsBaseVertex(GL_TRIANGLES, mesh.count() / 5, GL_UNSIGNED_INT, nullptr,
                                                k * vertices);
                  }),
            0u);
  EXPECT_GT(drawn("feedback_strip",
                  [](Gl gl, const ProgramMesh& mesh) {
                    gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(400);
                    gl.DrawElements(GL_TRIANGLE_STRIP, mesh.count(), GL_UNSIGNED_INT, nullptr);
                    gl.Disable(GL_PRIMITIVE_RESTART);
                  }),
            0u);
  EXPECT_GT(drawn("feedback_order",
                  [](Gl gl, const ProgramMesh& mesh) {
                    gl.DrawArrays(GL_TRIANGLES, 300,
                                  static_cast<GLsizei>(mesh.positions.size() / 3 * 3 - 300));
                  }),
            0u);
  EXPECT_GT(drawn("feedback_discards",
                  [](Gl gl, const ProgramMesh& mesh) {
                    gl.Enable(GL_CULL_FACE);
                    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
                    gl.Disable(GL_CULL_FACE);
                  }),
            0u);
  EXPECT_GT(drawn("feedback_instances",
                  [](Gl gl, const ProgramMesh& mesh) {
                    gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, 2);
                  }),
            0u);
}

/// By fixed function's arrays, in buffers.
TEST(FeedbackDraws, OfBuiltInVertices) {
  const ProgramMesh mesh = shells(5, 100);
  GLuint program = 0;
  const gl::Statistics counts = compareFrames(
      "feedback_built_in", 5,
      [&](Gl gl) {
        program = makeProgram(
            gl,
            "varying vec3 n; void main() { n = gl_NormalMatrix * gl_Normal; vec4 v = gl_Vertex;"
            " v.xyz *= 1.0 + 0.1 * sin(9.0 * v.y); gl_Position = gl_ModelViewProjectionMatrix * v; }",
            "varying vec3 n; void main() { gl_FragColor = vec4(0.5 + 0.5 * normalize(n), 1.0); }");
        for (const auto* const values : {&mesh.positions, &mesh.normals}) {
          GLuint buffer = 0;
          gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
          gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values->size() * sizeof(glm::vec3)),
                        values->data(), GL_STATIC_DRAW);
          if (values == &mesh.positions)
            gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_VERTEX_ARRAY);
          else
            gl.NormalPointer(GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_NORMAL_ARRAY);
        }
        GLuint indices = 0;
        gl.GenBuffers(1, &indices), gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh.indices.size() * sizeof(GLuint)),
                      mesh.indices.data(), GL_STATIC_DRAW);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program);
        gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity(), gl.Frustum(-0.2, 0.2, -0.2, 0.2, 0.5, 20);
        gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity(), gl.Translatef(0.1f, 0, -4);
        gl.Rotatef(7.0f * static_cast<float>(frame), 0.3f, 1, 0.2f);
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
      },
      nullptr, {kSide, kSide});
  EXPECT_GT(counts.drawsCulled, 0u);
}

/// What the program feeds back itself, and its state for that, stay as they are.
TEST(FeedbackDraws, LeaveTheProgramsOwnFeedbackAlone) {
  GLuint program = 0, own = 0, buffer = 0;
  const ProgramMesh mesh = shells(5, 100);
  std::vector<std::vector<GLfloat>> seen;
  const gl::Statistics counts = compareFrames(
      "own_feedback", 4,
      [&](Gl gl) {
        program = makeProgram(gl, kWaves, kCulledFragment);
        send(gl, mesh, program);
        own = makeProgram(gl, kCulledVertex, kCulledFragment);
        const char* const captured = "place";
        gl.TransformFeedbackVaryings(own, 1, &captured, GL_INTERLEAVED_ATTRIBS), gl.LinkProgram(own);
        gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_TRANSFORM_FEEDBACK_BUFFER, buffer);
        gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 64 * sizeof(GLfloat), nullptr, GL_DYNAMIC_READ);
        gl.BindBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer, 16, 48 * sizeof(GLfloat));
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program);
        turn(gl, program, frame);
        setTime(gl, program, frame);
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
        gl.UseProgram(own);
        gl.BeginTransformFeedback(GL_POINTS);
        gl.DrawArrays(GL_POINTS, 3 * frame, 4);
        gl.EndTransformFeedback();
        std::vector<GLfloat> values(16);
        gl.GetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 16, 12 * sizeof(GLfloat), values.data());
        seen.push_back(values);
      });
  EXPECT_GT(counts.drawsCulled, 0u);
  ASSERT_EQ(seen.size(), 8u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(seen[i], seen[i + 4]);
    EXPECT_EQ(seen[i][0], mesh.positions[3 * i].x);
  }
}

/// Programs of which no copy can be made, draws during feedback, and arrays in memory.
TEST(FeedbackDraws, AreWholeWherePositionsCannotBeFedBack) {
  FedScene doubles{replacedIn(
      moving("uniform dmat4 turned;", "vec3(turned * dvec4(position, 1.0)) * (1.0 + 0.1 * sin(position.y))"),
      "#version 150", "#version 150\n#extension GL_ARB_gpu_shader_fp64 : require")};
  doubles.before = [](Gl gl, GLuint program, int) {
    const glm::dmat4 one(1);
    gl.UniformMatrix4dv(gl.GetUniformLocation(program, "turned"), 1, GL_FALSE, &one[0][0]);
  };
  EXPECT_EQ(compare("doubles", doubles).drawsCulled, 0u);
  FedScene early{kWaves};
  early.fragment = replacedIn(kCulledFragment, "void main() {", "void main() {\n  gl_FragDepth = 0.5;");
  EXPECT_EQ(compare("feedback_depth", early).drawsCulled, 0u);
}

}  // namespace
}  // namespace gluray::test
