// Primitives spread over several display lists, and errors inside glBegin of lists: the same calls to the
// real OpenGL and through GLuRay must give the same errors and pixels.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
using Errors = std::vector<GLenum>;

constexpr int kPiecesSize = 32;

void error(Gl gl, Errors& errors) { errors.push_back(gl.GetError()); }

void corners(Gl gl, int first = 0, int end = 3) {
  constexpr float kCorners[3][3] = {{-1, -1, 0}, {1, -1, 0.1f}, {0, 1, 0.2f}};
  for (int i = first; i < end; ++i) gl.Vertex3fv(kCorners[i]);
}

template <class Calls>
void list(Gl gl, GLuint name, GLenum mode, Calls&& calls) {
  gl.NewList(name, mode), calls(), gl.EndList();
}

struct PieceCase {
  const char* name;
  void (*calls)(Gl gl, Errors& errors);
};
void PrintTo(const PieceCase& c, std::ostream* out) { *out << c.name; }

const PieceCase kPieceCases[] = {
    {"glBegin, vertices and glEnd in a list each",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Begin(GL_TRIANGLES); }), error(gl, e);
       list(gl, 2, GL_COMPILE, [&] { gl.Color3f(1, 0, 0), corners(gl); }), error(gl, e);
       list(gl, 3, GL_COMPILE, [&] { gl.End(); }), error(gl, e);
       for (GLuint i = 1; i < 4; ++i) gl.CallList(i);
       error(gl, e);
     }},
    {"a list that calls those",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Begin(GL_TRIANGLES), gl.Color3f(1, 1, 0), corners(gl, 0, 1); });
       list(gl, 2, GL_COMPILE, [&] { gl.Color3f(1, 0, 0), corners(gl, 1, 3); });
       list(gl, 3, GL_COMPILE, [&] { gl.End(); });
       list(gl, 4, GL_COMPILE, [&] {
         for (GLuint i = 1; i < 4; ++i) gl.CallList(i);
       });
       gl.CallList(4), error(gl, e);
     }},
    {"vertices of the caller in the primitive of a list",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Begin(GL_TRIANGLES), corners(gl, 0, 2); });
       gl.CallList(1), gl.Color3f(0, 1, 0), corners(gl, 2, 3), gl.End(), error(gl, e);
     }},
    {"a list called inside glBegin of the program",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Color3f(0, 1, 0), corners(gl, 0, 2); });
       gl.Begin(GL_TRIANGLES), gl.CallList(1), corners(gl, 2, 3), gl.End(), error(gl, e);
     }},
    {"a list called inside glBegin of a list",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Color3f(0, 1, 0), corners(gl, 1, 2); });
       list(gl, 2, GL_COMPILE,
            [&] { gl.Begin(GL_TRIANGLES), corners(gl, 0, 1), gl.CallList(1), corners(gl, 2, 3), gl.End(); });
       gl.CallList(2), error(gl, e);
     }},
    {"that is another one by the time of the call",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Color3f(0, 1, 0); });
       list(gl, 2, GL_COMPILE, [&] { gl.Begin(GL_TRIANGLES), gl.CallList(1), corners(gl), gl.End(); });
       list(gl, 1, GL_COMPILE, [&] { gl.Color3f(1, 0, 0); });
       gl.CallList(2), error(gl, e);
     }},
    {"a draw called inside glBegin",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Rectf(-1, -1, 1, 1); });
       gl.Begin(GL_TRIANGLES), gl.CallList(1), gl.End(), error(gl, e);
     }},
    {"a state called inside glBegin",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Enable(GL_LIGHTING); });
       gl.Begin(GL_TRIANGLES), gl.CallList(1), corners(gl), gl.End(), error(gl, e);
     }},
    {"glEnable inside glBegin of a list that is executed, too",
     [](Gl gl, Errors& e) {
       gl.NewList(1, GL_COMPILE_AND_EXECUTE);
       gl.Begin(GL_TRIANGLES), gl.Enable(GL_LIGHTING), corners(gl), gl.End(), gl.EndList(), error(gl, e);
       gl.CallList(1), error(gl, e);
     }},
    {"the same of a list that is not",
     [](Gl gl, Errors& e) {
       gl.NewList(1, GL_COMPILE);
       gl.Begin(GL_TRIANGLES), gl.Enable(GL_LIGHTING), corners(gl), gl.End(), gl.EndList(), error(gl, e);
       gl.CallList(1), error(gl, e);
     }},
    {"one value for a colour, inside glBegin of a list",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE,
            [&] { gl.Begin(GL_TRIANGLES), gl.Materialf(GL_FRONT, GL_DIFFUSE, 0.5f), corners(gl), gl.End(); });
       error(gl, e), gl.CallList(1), error(gl, e);
     }},
    {"glEndList inside glBegin of the program",
     [](Gl gl, Errors& e) { gl.Begin(GL_TRIANGLES), corners(gl), gl.EndList(), gl.End(), error(gl, e); }},
    {"glEndList inside glBegin of a list that is executed",
     [](Gl gl, Errors& e) {
       gl.NewList(1, GL_COMPILE_AND_EXECUTE);
       gl.Begin(GL_TRIANGLES), corners(gl), gl.EndList(), gl.End(), error(gl, e);
       e.push_back(gl.GetString(GL_VENDOR) != nullptr);
     }},
    {"a mode that does not exist, in a list",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.Begin(0x1234), gl.End(); }), error(gl, e);
       gl.CallList(1), error(gl, e);
     }},
    {"a draw of no mode inside glBegin",
     [](Gl gl, Errors& e) { gl.Begin(GL_POLYGON), gl.DrawArrays(0x4219, 0, 3), gl.End(), error(gl, e); }},
    {"many draws of no mode",
     [](Gl gl, Errors& e) { gl.MultiDrawArrays(0x1234, nullptr, nullptr, 0), error(gl, e); }},
    {"many draws of a negative number",
     [](Gl gl, Errors& e) {
       constexpr float kAll[9] = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
       constexpr GLint kFirst[2] = {0, 0};
       constexpr GLsizei kCount[2] = {3, -3};
       gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, kAll);
       gl.MultiDrawArrays(GL_TRIANGLES, kFirst, kCount, -1), error(gl, e);
       gl.MultiDrawArrays(GL_TRIANGLES, kFirst, kCount, 2), error(gl, e);
     }},
    {"many elements",
     [](Gl gl, Errors& e) {
       constexpr GLuint kIndices[3] = {0, 1, 2};
       const void* const indices[1] = {kIndices};
       constexpr GLsizei kCount[1] = {-3};
       gl.MultiDrawElements(GL_TRIANGLES, kCount, GL_UNSIGNED_INT, indices, -1), error(gl, e);
       gl.MultiDrawElements(0x1234, kCount, GL_UNSIGNED_INT, indices, 0), error(gl, e);
       gl.MultiDrawElements(GL_TRIANGLES, kCount, GL_FLOAT, indices, 0), error(gl, e);
       gl.MultiDrawElements(GL_TRIANGLES, kCount, GL_UNSIGNED_INT, indices, 1), error(gl, e);
     }},
    {"one number for a colour, in lists",
     [](Gl gl, Errors& e) {
       list(gl, 1, GL_COMPILE, [&] { gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1); });
       list(gl, 2, GL_COMPILE, [&] { gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1); });
       list(gl, 3, GL_COMPILE, [&] { gl.Fogf(GL_FOG_COLOR, 1); });
       list(gl, 4, GL_COMPILE, [&] { gl.Lightf(GL_LIGHT0, GL_DIFFUSE, 1); });
       list(gl, 5, GL_COMPILE, [&] { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, 1); });
       list(gl, 6, GL_COMPILE, [&] { gl.LightModeli(GL_LIGHT_MODEL_AMBIENT, 1); });
       for (GLuint i = 1; i < 7; ++i) error(gl, e), gl.CallList(i), error(gl, e);
       gl.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, 1), error(gl, e);
     }},
};

class ListPieces : public testing::TestWithParam<PieceCase> {};

TEST_P(ListPieces, AreThoseOfTheRealOne) {
  const auto draw = [](Gl gl, Errors& errors) {
    gl.Enable(GL_DEPTH_TEST), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    GetParam().calls(gl, errors);
    error(gl, errors);
    // After any calls, another primitive can be drawn.
    gl.Begin(GL_TRIANGLES), gl.Color3f(0, 0, 1);
    gl.Vertex3f(0.5f, 0.5f, -0.5f), gl.Vertex3f(1, 0.5f, -0.5f), gl.Vertex3f(1, 1, -0.6f);
    gl.End(), error(gl, errors);
    GLubyte pixels[2][4] = {};
    gl.ReadPixels(kPiecesSize / 2, kPiecesSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels[0]);
    gl.ReadPixels(kPiecesSize - 2, kPiecesSize - 6, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels[1]);
    for (const auto& pixel : pixels) errors.insert(errors.end(), pixel, pixel + 4);
  };
  Errors expected, ours;
  const auto real = OsmesaContext::create({kPiecesSize, kPiecesSize});
  draw(real->real(), expected);
  const TracedContext traced({kPiecesSize, kPiecesSize});
  draw(traced.gl(), ours);
  EXPECT_EQ(ours, expected);
}

/// Mesa executes such lists at their ends, and knows nothing of the glBegin before.
TEST(ListQuestions, AreErrorsInsideGlBegin) {
  const TracedContext traced({kPiecesSize, kPiecesSize});
  Gl gl = traced.gl();
  gl.NewList(1, GL_COMPILE_AND_EXECUTE);
  gl.Begin(GL_TRIANGLES);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR)) << "not to be asked here";
  EXPECT_EQ(gl.GenLists(1), 0u);
  corners(gl), gl.End();
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_OPERATION));
  gl.EndList(), gl.CallList(1);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR)) << "lists do not take questions";
}

INSTANTIATE_TEST_SUITE_P(Reference, ListPieces, testing::ValuesIn(kPieceCases),
                         [](const auto& info) { return std::to_string(info.index); });

}  // namespace
}  // namespace gluray::test
