// Programs as objects: relinked, deleted, names reused, shared between contexts, invalid.
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Lights = Surface::Lights;

View placedAside(double x) {
  View view = perspectiveView(20);
  view.eyeFromObject = glm::scale(glm::translate(view.eyeFromObject, {x, 0, 0}), glm::dvec3(0.6));
  return view;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
  return text;
}

/// A ball drawn by each of two programs, with an action in between.
void drawTwo(Gl gl, const std::function<GLuint(GLuint first)>& between) {
  const Surface surface{.lightCount = 2};
  const ProgramMesh mesh = ball(16);
  const GLuint first = makeProgram(gl, surface);
  const Upload up = upload(gl, mesh, first);
  beginFrame(gl);
  drawSurface(gl, first, up, mesh, placedAside(-0.8), surface);
  const GLuint second = between(first);
  gl.UseProgram(second);
  setAll(gl, second, placedAside(0.8), surface);
  gl.BindVertexArray(upload(gl, mesh, second).array);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

TEST(ProgramObjects, LinkedAgainAsAnotherSurface) {
  expectBoth(
      "relinked",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          const Surface other{.color = Color::vertex, .lights = Lights::none};
          GLuint shaders[2] = {};
          GLsizei count = 0;
          gl.GetAttachedShaders(program, 2, &count, shaders);
          for (GLsizei i = 0; i < count; ++i) gl.DetachShader(program, shaders[i]);
          const GLuint donor = makeProgram(gl, other);
          gl.GetAttachedShaders(donor, 2, &count, shaders);
          for (GLsizei i = 0; i < count; ++i) gl.AttachShader(program, shaders[i]);
          gl.LinkProgram(program);
          return program;
        });
      },
      2);
}

TEST(ProgramObjects, LinkedAgainWithoutSuccess) {
  expectBoth(
      "unlinked",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          GLuint shaders[2] = {};
          GLsizei count = 0;
          gl.GetAttachedShaders(program, 2, &count, shaders);
          const char* wrong = "#version 150\nvoid main() { nothing }\n";
          gl.ShaderSource(shaders[0], 1, &wrong, nullptr), gl.CompileShader(shaders[0]);
          gl.LinkProgram(program);  // fails: what is in use stays, and can still be drawn with
          const ProgramMesh mesh = ball(8);
          gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
          return makeProgram(gl, Surface{.lightCount = 2});
        });
      },
      -1);
}

TEST(ProgramObjects, NeverLinked) {
  expectBoth(
      "never_linked",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint) {
          gl.UseProgram(gl.CreateProgram());  // refused: the first one stays in use
          gl.DrawArrays(GL_TRIANGLES, 0, 3);
          return makeProgram(gl, Surface{.lightCount = 2});
        });
      },
      3);
}

TEST(ProgramObjects, DeletedWhileInUseAndItsNameUsedAgain) {
  expectBoth(
      "deleted",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          gl.DeleteProgram(program);  // it lives on as long as it is in use
          const ProgramMesh mesh = ball(8);
          for (const double x : {-0.2, 0.2}) {
            setView(gl, program, placedAside(x));
            gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
            gl.Finish();
          }
          gl.UseProgram(0);
          return makeProgram(gl, Surface{.color = Color::vertex, .lights = Lights::headlight});
        });
      },
      2);
}

/// Their vertices are kept, although the draws are not hidden from the viewer.
TEST(ProgramObjects, FedBackWhileTheyDraw) {
  std::vector<std::vector<float>> kept;
  const ProgramMesh mesh = ball(16);
  const auto draw = [&](Gl gl) {
    const Surface surface{.lightCount = 2};
    const GLuint program = makeProgram(gl, surface);
    const char* const position = "gl_Position";
    gl.TransformFeedbackVaryings(program, 1, &position, GL_INTERLEAVED_ATTRIBS);
    gl.LinkProgram(program);
    const Upload up = upload(gl, mesh, program);
    GLuint buffer = 0;
    std::vector<float> places(4 * mesh.indices.size(), -5.0f);
    const auto bytes = static_cast<GLsizeiptr>(places.size() * sizeof(float));
    gl.GenBuffers(1, &buffer), gl.BindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
    gl.BufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, places.data(), GL_STATIC_DRAW);
    beginFrame(gl);
    gl.UseProgram(program);
    gl.BeginTransformFeedback(GL_TRIANGLES);
    drawSurface(gl, program, up, mesh, placedAside(0.1), surface);
    gl.EndTransformFeedback();
    gl.GetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, places.data());
    kept.push_back(places);
  };
  expectSame("fed_back", draw, 0);
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_EQ(kept[0], kept[1]);
  EXPECT_NE(kept[0].back(), -5.0f);
}

TEST(ProgramObjects, LinkedAgainWithOtherPlacesOfUniforms) {
  expectBoth(
      "replaced",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          gl.BindAttribLocation(program, 7, "vertexMC");
          gl.LinkProgram(program);
          return program;
        });
      },
      2);
}

TEST(ProgramObjects, NoProgramInACoreProfile) {
  expectBoth(
      "none",
      [](Gl gl) {
        drawTwo(gl, [&](GLuint program) {
          gl.UseProgram(0);
          gl.DrawArrays(GL_TRIANGLES, 0, 3);  // undefined, but not the end
          return program;
        });
      },
      -1);
}

TEST(ProgramObjects, TwoContextsOfAShareGroup) {
  // The uniforms of each context's program are reset by relinking it in the other context.
  const auto frame = [](Gl gl, GLuint program, const Surface& surface, const ProgramMesh& mesh) {
    const Upload up = upload(gl, mesh, program);
    beginFrame(gl);
    drawSurface(gl, program, up, mesh, perspectiveView(), surface);
    return readImage(gl, kProgramWidth, kProgramHeight);
  };
  const Surface first{.lightCount = 2};
  const ProgramMesh mesh = ball(24);
  const auto all = [&](Gl one, Gl two, auto&& useOne, auto&& useTwo) {
    std::vector<DrawnImage> images;
    useOne();
    const GLuint program = makeProgram(one, first);
    images.push_back(frame(one, program, first, mesh));
    useTwo();
    images.push_back(frame(two, program, first, mesh));
    two.BindAttribLocation(program, 5, "vertexMC"), two.LinkProgram(program);
    images.push_back(frame(two, program, first, mesh));
    useOne();
    images.push_back(frame(one, program, first, mesh));
    return images;
  };
  std::vector<DrawnImage> expected;
  {
    const auto one = OsmesaContext::create(coreWish()), two = OsmesaContext::create(coreWish(), one.get());
    expected = all(
        one->real(), two->real(), [&] { one->makeCurrent(); }, [&] { two->makeCurrent(); });
  }
  TracedContext one(coreWish(), TracedContext::tracing()),
      two(coreWish(), TracedContext::tracing(), nullptr, &one);
  const std::vector<DrawnImage> got = all(
      one.gl(), two.gl(), [&] { one.makeCurrent(); }, [&] { two.makeCurrent(); });
  for (size_t i = 0; i < expected.size(); ++i) {
    const Comparison c = compare(expected[i], got[i], kProgramTolerance);
    EXPECT_TRUE(c.accepted) << i << ": " << c.text;
  }
  EXPECT_EQ(one.context().counts.statistics.drawsTraced, 2u);
  EXPECT_EQ(two.context().counts.statistics.drawsTraced, 2u);
}

/// VTK's names with other types: not the program that the family describes.
struct WrongType {
  const char *name, *what, *by, *use, *instead;
};
const WrongType kWrongTypes[] = {
    {"matrix_of_3x3", "uniform mat4 MCDCMatrix", "uniform mat3 MCDCMatrix", "MCDCMatrix * vertexMC",
     "vec4(MCDCMatrix * vertexMC.xyz, 4.0)"},
    {"matrix_as_array", "uniform mat4 MCDCMatrix", "uniform vec4 MCDCMatrix[4]", "MCDCMatrix * vertexMC",
     "MCDCMatrix[0] * vertexMC.x + MCDCMatrix[1] * vertexMC.y + MCDCMatrix[2] * vertexMC.z + MCDCMatrix[3]"},
    {"positions_of_integers", "in vec4 vertexMC", "in ivec4 vertexMC", "Matrix * vertexMC",
     "Matrix * vec4(intBitsToFloat(vertexMC.x), intBitsToFloat(vertexMC.y), intBitsToFloat(vertexMC.z), "
     "1.0)"},
};
class WrongTypes : public testing::TestWithParam<WrongType> {};

TEST_P(WrongTypes, AreLeftToTheRealOne) {
  const WrongType& w = GetParam();
  expectSame(
      w.name,
      [&](Gl gl) {
        const Surface surface{.version = "#version 330\n"};
        const ProgramMesh mesh = ball(16);
        const GLuint program =
            makeProgram(gl, replaced(replaced(vertexText(surface), w.what, w.by), w.use, w.instead),
                        fragmentText(surface));
        const Upload up = upload(gl, mesh, program);
        if (std::string(w.by).find("ivec4") != std::string::npos) {
          gl.BindBuffer(GL_ARRAY_BUFFER, up.positions);
          gl.VertexAttribIPointer(static_cast<GLuint>(gl.GetAttribLocation(program, "vertexMC")), 3, GL_INT,
                                  0, nullptr);
        }
        beginFrame(gl);
        gl.UseProgram(program);
        const View view = perspectiveView();
        setAll(gl, program, view, surface);
        const glm::mat4 clip(view.clipFromEye * view.eyeFromObject);
        const GLint place = gl.GetUniformLocation(program, "MCDCMatrix");
        gl.Uniform4fv(place, 4, glm::value_ptr(clip));
        setMat3(gl, program, "MCDCMatrix", glm::mat3(1));
        while (gl.GetError() != GL_NO_ERROR) {}  // one of the two is of the wrong type
        setMat4(gl, program, "MCDCMatrix", clip);
        while (gl.GetError() != GL_NO_ERROR) {}
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
      },
      0, coreWish(3, 3));
}
INSTANTIATE_TEST_SUITE_P(All, WrongTypes, testing::ValuesIn(kWrongTypes),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
