// Bugs that the fuzzer found, reduced: the real OpenGL and GLuRay must give the same results.
#include "tests/fuzz/found/found.h"

#include "gl/arrays/arrays.h"
#include "gl/capture/mesh_builder.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace gluray::test {
namespace {

const Found kFound[] = {
    {"the first error stays, whoever finds it",
     [](Gl gl, Answers& a) { gl.ShadeModel(7), gl.EndList(), error(gl, a), error(gl, a); }},
    {"an error in a rasterised primitive comes in its turn",
     [](Gl gl, Answers& a) {
       gl.Begin(GL_LINE_STRIP), gl.Materialf(GL_FRONT, GL_SHININESS, -5), gl.Ortho(0, 1, 0, 1, 0, 1),
           gl.End(), error(gl, a);
     }},
    {"glEnd of a list belongs to its caller",
     [](Gl gl, Answers& a) {
       gl.NewList(1, GL_COMPILE), gl.End(), gl.EndList(), error(gl, a);
       gl.CallList(1), error(gl, a);
       gl.Begin(GL_TRIANGLES), gl.CallList(1), error(gl, a);
     }},
    {"a list that sets state between glBegin and glEnd",
     [](Gl gl, Answers& a) {
       gl.NewList(1, GL_COMPILE), gl.ShadeModel(GL_FLAT), gl.EndList();
       gl.Begin(GL_TRIANGLES), gl.CallList(1), gl.End(), error(gl, a), four(gl, GL_SHADE_MODEL, a);
     }},
    {"names of lists",
     [](Gl gl, Answers& a) {
       gl.NewList(10, GL_COMPILE), gl.EndList();
       a.push_back(static_cast<float>(gl.GenLists(3))), gl.DeleteLists(11, 2);
       a.push_back(static_cast<float>(gl.GenLists(1)));
     }},
    {"glBegin into an incomplete framebuffer",
     [](Gl gl, Answers& a) {
       GLuint name = 0;
       gl.GenFramebuffers(1, &name), gl.BindFramebuffer(GL_FRAMEBUFFER, name);
       gl.Begin(GL_TRIANGLES), error(gl, a), gl.End(), error(gl, a);
       a.push_back(static_cast<float>(gl.GenLists(1))), error(gl, a);
     }},
    {"attribute stacks that run over",
     [](Gl gl, Answers& a) {
       gl.ListBase(5);
       for (int i = 0; i < 20; ++i) gl.PushAttrib(GL_LIST_BIT), gl.ListBase(static_cast<GLuint>(i));
       for (int i = 0; i < 3; ++i) gl.PopAttrib(), four(gl, GL_LIST_BASE, a);
       error(gl, a);
     }},
    {"materials that a list refuses",
     [](Gl gl, Answers& a) {
       gl.NewList(1, GL_COMPILE), gl.Materialf(GL_FRONT, GL_SHININESS, -1), gl.EndList(), error(gl, a);
       gl.CallList(1), error(gl, a);
       gl.NewList(2, GL_COMPILE), gl.Begin(GL_LINES), gl.Materialfv(GL_FRONT, GL_TEXTURE_2D, kValues),
           gl.End(), gl.EndList();
       error(gl, a), gl.CallList(2), error(gl, a);
     }},
    {"glPopClientAttrib of nothing, while a buffer is mapped whose name was deleted before",
     [](Gl gl, Answers& a) {
       GLuint array = 0;
       gl.GenVertexArrays(1, &array), gl.BindVertexArray(array);
       const GLuint name = 1;
       for (const bool again : {false, true}) {
         gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, name);
         gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kValues, kValues, GL_STATIC_DRAW);
         if (!again) gl.DeleteBuffers(1, &name);
       }
       gl.MapBuffer(GL_ELEMENT_ARRAY_BUFFER, GL_READ_WRITE), gl.PopClientAttrib(), error(gl, a);
       a.push_back(static_cast<float>(gl.UnmapBuffer(GL_ELEMENT_ARRAY_BUFFER))), error(gl, a);
     }},
    {"generic attribute 0 from a buffer",
     [](Gl gl, Answers& a) {
       gl.BindBuffer(GL_ARRAY_BUFFER, 1),
           gl.BufferData(GL_ARRAY_BUFFER, sizeof kValues, kValues, GL_STATIC_DRAW);
       gl.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr), gl.EnableVertexAttribArray(0);
       gl.DrawArrays(GL_TRIANGLES, 0, 3), gl.Finish(), error(gl, a);
     }},
    {"a draw from a buffer that is mapped",
     [](Gl gl, Answers& a) {
       gl.BindBuffer(GL_ARRAY_BUFFER, 1),
           gl.BufferData(GL_ARRAY_BUFFER, sizeof kValues, kValues, GL_STATIC_DRAW);
       gl.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr), gl.EnableVertexAttribArray(0);
       gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
       gl.DrawArrays(GL_TRIANGLES, 0, 3), gl.Finish();
       a.push_back(static_cast<float>(gl.UnmapBuffer(GL_ARRAY_BUFFER)));
     }},
    {"glArrayElement outside glBegin, of an array that is not captured",
     [](Gl gl, Answers& a) {
       static constexpr GLubyte kFlags[4] = {0, 0, 0, 0};
       gl.EdgeFlagPointer(0, kFlags), gl.EnableClientState(GL_EDGE_FLAG_ARRAY), gl.ArrayElement(1);
       four(gl, GL_EDGE_FLAG, a), error(gl, a);
     }},
    {"a material before an array element that is not captured, in a list",
     [](Gl gl, Answers& a) {
       gl.VertexAttribPointer(3, 4, GL_FLOAT, GL_FALSE, 0, kValues), gl.EnableVertexAttribArray(3);
       gl.NewList(1, GL_COMPILE), gl.Begin(GL_TRIANGLES), gl.Materialfv(GL_FRONT, GL_AMBIENT, kValues),
           gl.ArrayElement(0);
       gl.Vertex2f(0, 0), gl.End(), gl.EndList(), gl.CallList(1);
       float v[4] = {};
       gl.GetMaterialfv(GL_FRONT, GL_AMBIENT, v), a.insert(a.end(), v, v + 4), error(gl, a);
     }},
    {"wrong draws in a list are errors when it is called",
     [](Gl gl, Answers& a) {
       gl.NewList(1, GL_COMPILE), gl.DrawElements(22320, 0, GL_UNSIGNED_INT, nullptr), error(gl, a);
       gl.DrawElements(GL_TRIANGLES, 1, GL_FLOAT, nullptr), error(gl, a), gl.EndList(), error(gl, a);
       gl.CallList(1), error(gl, a);
     }},
    {"a mapping of a buffer without memory",
     [](Gl gl, Answers& a) {
       gl.BindBuffer(GL_ARRAY_BUFFER, 6);
       gl.MapBufferRange(GL_ARRAY_BUFFER, 0, 32, GL_MAP_WRITE_BIT), error(gl, a);
     }},
    {"a draw without positions, in feedback",
     [](Gl gl, Answers& a) {
       static GLfloat memory[256];
       gl.FeedbackBuffer(256, GL_3D, memory), gl.RenderMode(GL_FEEDBACK);
       gl.DrawArrays(GL_POINTS, 0, 3);
       a.push_back(static_cast<float>(gl.RenderMode(GL_RENDER)));
     }},
    {"an instanced draw while a list is compiled is an error, and not in the list",
     [](Gl gl, Answers& a) {
       static GLfloat memory[256];
       gl.FeedbackBuffer(256, GL_3D, memory);
       gl.VertexPointer(3, GL_FLOAT, 0, kValues), gl.EnableClientState(GL_VERTEX_ARRAY);
       for (const bool vertices : {false, true}) {
         gl.NewList(1, GL_COMPILE);
         if (vertices)
           gl.Begin(GL_TRIANGLES), gl.Vertex2f(0, 0), gl.Vertex2f(0, 1), gl.Vertex2f(1, 1), gl.End();
         gl.DrawArraysInstanced(GL_POLYGON, 0, 3, 2), error(gl, a);
         gl.DrawElementsInstanced(GL_TRIANGLES, 0, GL_UNSIGNED_BYTE, nullptr, 2), error(gl, a);
         gl.DrawArraysInstanced(GL_TRIANGLES, 0, 3, 0), error(gl, a);
         gl.DrawElementsInstanced(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, "\0\1\2", 2), error(gl, a);
         gl.EndList(), gl.RenderMode(GL_FEEDBACK), gl.CallList(1), error(gl, a);
         a.push_back(static_cast<float>(gl.RenderMode(GL_RENDER))), error(gl, a);
       }
     }},
    {"glPopAttrib in a list brings back what was current",
     [](Gl gl, Answers& a) {
       gl.NewList(1, GL_COMPILE), gl.PopAttrib(), gl.EndList();
       gl.PushAttrib(GL_ALL_ATTRIB_BITS), gl.SecondaryColor3f(0.25f, 0.5f, 0.75f), gl.CallList(1);
       four(gl, GL_CURRENT_SECONDARY_COLOR, a), error(gl, a);
     }},
    {"commands on a buffer beside the range that is mapped, and upon it",
     [](Gl gl, Answers& a) {
       for (const GLbitfield access : {GL_MAP_READ_BIT, GL_MAP_WRITE_BIT}) {
         GLfloat got[4] = {};
         gl.BindBuffer(GL_ARRAY_BUFFER, 1), gl.BindBuffer(GL_COPY_READ_BUFFER, 2);
         gl.BufferData(GL_ARRAY_BUFFER, sizeof kValues, kValues, GL_STATIC_DRAW);
         gl.BufferData(GL_COPY_READ_BUFFER, sizeof kValues, kValues, GL_STATIC_DRAW);
         gl.MapBufferRange(GL_ARRAY_BUFFER, 32, 32, access), error(gl, a);
         gl.BufferSubData(GL_ARRAY_BUFFER, 0, 32, kValues + 1), error(gl, a);
         gl.BufferSubData(GL_ARRAY_BUFFER, 64, 32, kValues + 1), error(gl, a);
         gl.BufferSubData(GL_ARRAY_BUFFER, 28, 8, kValues), error(gl, a);
         gl.BufferSubData(GL_ARRAY_BUFFER, 60, 8, kValues), error(gl, a);
         gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, 16, got), error(gl, a);
         gl.GetBufferSubData(GL_ARRAY_BUFFER, 32, 16, got), error(gl, a);
         gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_ARRAY_BUFFER, 0, 0, 16), error(gl, a);
         gl.CopyBufferSubData(GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, 0, 0, 16), error(gl, a);
         a.insert(a.end(), got, got + 4);
         gl.UnmapBuffer(GL_ARRAY_BUFFER), gl.GetBufferSubData(GL_ARRAY_BUFFER, 0, 16, got), error(gl, a);
         a.insert(a.end(), got, got + 4);
       }
     }},
    {"glBegin of a mode that does not exist is an error when the list is called",
     [](Gl gl, Answers& a) {
       gl.NewList(1, GL_COMPILE), gl.Begin(8952), error(gl, a), gl.End(), gl.EndList(), error(gl, a);
       gl.CallList(1), error(gl, a), error(gl, a);
     }},
    {"a vertex of an evaluator in a list, after attributes that nobody has seen yet",
     [](Gl gl, Answers& a) {
       gl.Begin(GL_TRIANGLES), gl.Vertex2f(0, 0), gl.Vertex2f(0, 1), gl.Vertex2f(1, 1), gl.End();
       gl.Color4f(0.25f, 0.5f, 0.75f, 1), gl.NewList(1, GL_COMPILE), gl.Begin(GL_POINTS), gl.EvalPoint1(1);
       gl.End(), four(gl, GL_CURRENT_COLOR, a), gl.EndList(), four(gl, GL_CURRENT_COLOR, a);
     }},
    {"the first of two errors in a rasterised primitive",
     [](Gl gl, Answers& a) {
       gl.DepthFunc(GL_GREATER), gl.Begin(GL_QUAD_STRIP), gl.Materialf(GL_FRONT, GL_SHININESS, -5);
       gl.Begin(GL_LINES), gl.End(), error(gl, a), error(gl, a);
       gl.Begin(GL_LINES), gl.Materialf(GL_FRONT, GL_SHININESS, -5), gl.Begin(GL_LINES), gl.End();
       error(gl, a), error(gl, a);
     }},
    {"a draw of nothing into an incomplete framebuffer, and one that is wrong twice",
     [](Gl gl, Answers& a) {
       gl.DrawElements(18835, -3, GL_UNSIGNED_INT, nullptr), error(gl, a);
       GLuint name = 0;
       gl.GenFramebuffers(1, &name), gl.BindFramebuffer(GL_FRAMEBUFFER, name);
       gl.DrawArraysInstanced(GL_TRIANGLES, 0, 30, 0), error(gl, a), gl.DrawArrays(GL_TRIANGLES, 0, 0),
           error(gl, a);
     }},
    {"a buffer is mapped while a list is compiled and executed",
     [](Gl gl, Answers& a) {
       gl.BindBuffer(GL_ARRAY_BUFFER, 1);
       gl.BufferData(GL_ARRAY_BUFFER, sizeof kValues, kValues, GL_STATIC_DRAW);
       gl.NewList(1, GL_COMPILE_AND_EXECUTE);
       gl.Normal3f(0, 0, 1), gl.Begin(GL_TRIANGLES), gl.Vertex4f(0, 0, 0, 1), gl.End();
       a.push_back(gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE) != nullptr), error(gl, a);
       a.push_back(gl.UnmapBuffer(GL_ARRAY_BUFFER)), gl.EndList(), error(gl, a);
     }},
    {"a draw with an array in a mapped buffer",
     [](Gl gl, Answers& a) {
       std::array<GLfloat, 1024> many{};
       for (size_t i = 0; i < many.size(); ++i) many[i] = static_cast<float>(i * 7919 % 101) / 50 - 1;
       gl.Enable(GL_DEPTH_TEST);
       gl.VertexPointer(3, GL_FLOAT, 0, many.data()), gl.EnableClientState(GL_VERTEX_ARRAY);
       gl.BindBuffer(GL_ARRAY_BUFFER, 5);
       gl.BufferData(GL_ARRAY_BUFFER, sizeof many, many.data(), GL_STATIC_DRAW);
       gl.TexCoordPointer(2, GL_FLOAT, 0, nullptr);
       gl.BindBuffer(GL_COPY_READ_BUFFER, 5);
       for (const bool before : {true, false}) {
         if (before) gl.MapBuffer(GL_COPY_READ_BUFFER, GL_WRITE_ONLY);
         gl.EnableClientState(GL_TEXTURE_COORD_ARRAY);
         gl.DrawArrays(GL_TRIANGLES, 0, 30);
         if (!before) gl.MapBuffer(GL_COPY_READ_BUFFER, GL_WRITE_ONLY);
         gl.DrawArrays(GL_TRIANGLES, 30, 30), error(gl, a);
         gl.UnmapBuffer(GL_COPY_READ_BUFFER), gl.DrawArrays(GL_TRIANGLES, 60, 30), error(gl, a);
       }
     }},
    {"a question inside glBegin, before an attribute that does not exist",
     [](Gl gl, Answers& a) {
       for (const GLenum mode : {GL_LINE_LOOP, GL_TRIANGLES}) {
         gl.Begin(mode), error(gl, a), gl.VertexAttrib2f(16, 1, 2), gl.End(), error(gl, a), error(gl, a);
         gl.Begin(mode), gl.VertexAttrib2f(16, 1, 2), error(gl, a), gl.End(), error(gl, a), error(gl, a);
       }
     }},
};

class FoundTest : public testing::TestWithParam<Found> {};

TEST_P(FoundTest, AnswersAreThoseOfTheRealOne) {
  Answers expected, got;
  {
    const auto real = OsmesaContext::create({32, 32});
    GetParam().calls(real->real(), expected);
  }
  TracedContext ours({32, 32});
  GetParam().calls(ours.gl(), got);
  EXPECT_EQ(got, expected) << GetParam().name;
  EXPECT_FALSE(ours.context().info().off);
}

INSTANTIATE_TEST_SUITE_P(Fuzzer, FoundTest, testing::ValuesIn(kFound));
INSTANTIATE_TEST_SUITE_P(Materials, FoundTest,
                         testing::ValuesIn(foundMaterials().begin(), foundMaterials().end()));
INSTANTIATE_TEST_SUITE_P(Lists, FoundTest, testing::ValuesIn(foundLists().begin(), foundLists().end()));

/// An enabled array without memory has no elements. Not drawn: the real OpenGL may read at null.
TEST(Found, ArraysAtNull) {
  TracedContext context({32, 32});
  gl::ArrayState arrays;
  arrays.vertex.enabled = arrays.color.enabled = true;
  arrays.vertex.size = 3, arrays.vertex.stride = 12, arrays.color.stride = 16;
  const gl::KnownMesh known =
      gl::buildArrayMesh(context.below().real(), arrays, GL_TRIANGLES, {0, 6, 0, nullptr, 0});
  EXPECT_EQ(known.mesh ? known.mesh->triangleCount : 0, 0u);
}

/// Programs that never swap: their meshes must not be kept.
TEST(Forgetting, MeshesGoWithoutSwapOrFinish) {
  TracedContext context({32, 32});
  Gl gl = context.gl();
  gl.Enable(GL_DEPTH_TEST);
  for (int frame = 0; frame < 200; ++frame) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.Begin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i)
      gl.Vertex3f(0.1f * static_cast<float>(i), 0.9f - static_cast<float>(i),
                  0.001f * static_cast<float>(frame));
    gl.End();
    uint32_t pixel = 0;
    gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
  }
  EXPECT_LE(context.context().shadow.sharedGroup->meshes.size(), 64u);
}

}  // namespace
}  // namespace gluray::test
