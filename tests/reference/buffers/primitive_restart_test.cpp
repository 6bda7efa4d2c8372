// Draws while primitive restart is switched on: traced where their indices do not name the one that restarts,
// else drawn by the real OpenGL.
#include "tests/reference/hostile/habits.h"
#include "tests/reference/programs/program_stage.h"
#include "tests/reference/triangle_field.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace triangle_field;
using namespace twenty_points;

/// Indices of all triangles of a field, in order.
template <class Index>
std::vector<Index> inOrder(int count = kVertices) {
  std::vector<Index> all(static_cast<size_t>(count));
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

/// The fixed function's arrays of the field, and an element buffer.
template <class Index>
void begin(Gl gl, const std::vector<Index>& indices) {
  stage(gl);
  gl.Disable(GL_LIGHTING);
  GLuint buffers[2] = {};
  gl.GenBuffers(2, buffers), gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER, kBytes, field(0.5f).data(), GL_STATIC_DRAW);
  gl.VertexPointer(3, GL_FLOAT, 0, nullptr), gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(Index)),
                indices.data(), GL_STATIC_DRAW);
  gl.Color3f(1, 0.5f, 0);
}

void fixedIndex(Gl gl, twenty_points::Seen&) {
  begin(gl, inOrder<GLushort>());
  gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  gl.DrawElements(GL_TRIANGLES, kVertices, GL_UNSIGNED_SHORT, nullptr);
  gl.Translatef(0, 0, 0.2f);
  gl.DrawElements(GL_TRIANGLES, 30, GL_UNSIGNED_SHORT, nullptr);  // so few that they are captured one by one
  gl.DrawArrays(GL_TRIANGLES, 60, 180);                           // together with those
}

void fixedIndexThatIsNamed(Gl gl, twenty_points::Seen&) {
  auto indices = inOrder<GLushort>();
  indices[100] = 0xFFFF, indices[200] = 0xFFFF;  // in the middle of triangles, so that the others shift
  begin(gl, indices);
  gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  gl.DrawElements(GL_TRIANGLES, kVertices, GL_UNSIGNED_SHORT, nullptr);
  gl.Translatef(0, 0, 0.2f);
  gl.DrawElements(GL_TRIANGLES, 30, GL_UNSIGNED_SHORT, reinterpret_cast<const void*>(180));
  gl.DrawElements(GL_TRIANGLES, 90, GL_UNSIGNED_SHORT, nullptr);  // these do not name it
}

/// As bytes, the restarting index is another one.
void bytes(Gl gl, twenty_points::Seen&) {
  auto indices = inOrder<GLubyte>(240);
  begin(gl, indices);
  gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(400);  // no byte
  gl.DrawElements(GL_TRIANGLES, 240, GL_UNSIGNED_BYTE, nullptr);
  gl.PrimitiveRestartIndex(90);
  gl.Color3f(0, 0.5f, 1), gl.Translatef(0.1f, 0, 0.2f);
  gl.DrawElements(GL_TRIANGLES, 240, GL_UNSIGNED_BYTE, nullptr);
}

/// A vertex that exists restarts; with a base vertex, indices are compared before it is added.
void indexOfAVertex(Gl gl, twenty_points::Seen&) {
  begin(gl, inOrder<GLuint>());
  gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(250);
  gl.DrawElements(GL_TRIANGLES, kVertices, GL_UNSIGNED_INT, nullptr);
  gl.Color3f(0, 0.5f, 1), gl.Translatef(0.1f, 0, 0.2f);
  gl.DrawElementsBaseVertex(GL_TRIANGLES, 201, GL_UNSIGNED_INT, nullptr, 90);
  gl.PrimitiveRestartIndex(0);
  gl.Translatef(0.1f, 0, 0.2f);
  gl.DrawElements(GL_TRIANGLES, 201, GL_UNSIGNED_INT, reinterpret_cast<const void*>(24));
}

void indexThatAppearsLater(Gl gl, twenty_points::Seen&) {
  begin(gl, inOrder<GLuint>());
  gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  const auto draw = [&](float x) {
    gl.PushMatrix(), gl.Translatef(x, 0, 0), gl.Scalef(0.3f, 0.3f, 0.3f);
    gl.DrawElements(GL_TRIANGLES, kVertices, GL_UNSIGNED_INT, nullptr);
    gl.PopMatrix();
  };
  draw(-0.7f);
  const GLuint restart = ~0u, before = 151;
  gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 151 * sizeof(GLuint), sizeof restart, &restart);
  draw(0);
  gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 151 * sizeof(GLuint), sizeof before, &before);
  draw(0.7f);
}

void inTheProgramsMemory(Gl gl, twenty_points::Seen&) {
  static const std::vector<float> positions = field(0.5f);
  static std::vector<GLushort> indices;
  indices = inOrder<GLushort>();
  stage(gl);
  gl.Disable(GL_LIGHTING), gl.Color3f(1, 0.5f, 0);
  gl.VertexPointer(3, GL_FLOAT, 0, positions.data()), gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(10000);
  gl.DrawElements(GL_TRIANGLES, kVertices, GL_UNSIGNED_SHORT, indices.data());
  indices[31] = 10000;
  gl.Color3f(0, 0.5f, 1), gl.Translatef(0.1f, 0, 0.2f);
  gl.DrawElements(GL_TRIANGLES, kVertices, GL_UNSIGNED_SHORT, indices.data());
  gl.Finish();
}

/// Display lists take the vertices when they are compiled.
void inAList(Gl gl, twenty_points::Seen&) {
  auto indices = inOrder<GLuint>();
  begin(gl, indices);
  gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(250);
  gl.NewList(1, GL_COMPILE);
  gl.DrawElements(GL_TRIANGLES, 240, GL_UNSIGNED_INT, nullptr);
  gl.EndList();
  gl.CallList(1);
}

void elementByElement(Gl gl, twenty_points::Seen&) {
  begin(gl, inOrder<GLuint>());
  gl.Enable(GL_PRIMITIVE_RESTART), gl.PrimitiveRestartIndex(4);
  gl.Begin(GL_TRIANGLE_STRIP);
  for (GLint i = 0; i < 12; ++i) gl.ArrayElement(i);
  gl.End();
}

void stripsThatRestart(Gl gl, twenty_points::Seen&) {
  std::vector<GLuint> indices;
  for (GLuint i = 0; i < kTriangles; ++i)
    for (const GLuint index : {3 * i, 3 * i + 1, 3 * i + 2, ~0u}) indices.push_back(index);
  begin(gl, indices);
  gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
  gl.DrawElements(GL_TRIANGLE_STRIP, 4 * kTriangles, GL_UNSIGNED_INT, nullptr);
}

struct Restart {
  const char* name;
  void (*draw)(Gl gl, twenty_points::Seen& seen);
  uint64_t traced, rasterised = 0;
};
void PrintTo(const Restart& restart, std::ostream* out) { *out << restart.name; }

class PrimitiveRestart : public testing::TestWithParam<Restart> {};

TEST_P(PrimitiveRestart, IsSeenInTheIndices) {
  const Restart& restart = GetParam();
  const gl::Statistics s = expectSame(restart.draw, {.traced = restart.traced});
  EXPECT_EQ(s.rasterisedBecause[static_cast<size_t>(gl::Reason::arrayState)], restart.rasterised);
}
INSTANTIATE_TEST_SUITE_P(FixedFunction, PrimitiveRestart,
                         testing::Values(Restart{"fixed_index", fixedIndex, 2},
                                         Restart{"fixed_index_that_is_named", fixedIndexThatIsNamed, 1, 2},
                                         Restart{"bytes", bytes, 1, 1},
                                         Restart{"index_of_a_vertex", indexOfAVertex, 2, 1},
                                         Restart{"index_that_appears_later", indexThatAppearsLater, 2, 1},
                                         Restart{"in_the_programs_memory", inTheProgramsMemory, 1, 1},
                                         Restart{"in_a_list", inAList, 1},
                                         Restart{"element_by_element", elementByElement, 0},
                                         Restart{"strips_that_restart", stripsThatRestart, 0, 1}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(PrimitiveRestartOfPrograms, IsSeenInTheIndices) {
  const ProgramMesh mesh = ball(20);
  const Surface surface{.color = Surface::Color::vertex, .version = "#version 430\n"};
  for (const bool named : {false, true}) {
    SCOPED_TRACE(named);
    expectBoth(
        named ? "restart_named" : "restart_not_named",
        [&](Gl gl) {
          const GLuint program = makeProgram(gl, surface);
          const Upload up = upload(gl, mesh, program);
          beginFrame(gl);
          gl.UseProgram(program);
          setAll(gl, program, perspectiveView(20), surface);
          gl.BindVertexArray(up.array);
          gl.Enable(GL_PRIMITIVE_RESTART_FIXED_INDEX);
          if (const GLuint restart = ~0u; named)
            gl.BufferSubData(GL_ELEMENT_ARRAY_BUFFER, 400, sizeof restart, &restart);
          gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
        },
        named ? 0 : 1, coreWish(4, 5));
  }
}

}  // namespace
}  // namespace gluray::test
