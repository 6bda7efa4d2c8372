// Values that the real OpenGL stores with the vertices it draws, while draws are held back: materials
// and colours inside glBegin, changes of GL_COLOR_MATERIAL, glPopAttrib. The same calls to the real OpenGL
// and through GLuRay must give the same query results and pixels.
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
using Answers = std::vector<float>;

constexpr int kLateValuesSize = 32;
constexpr GLfloat kRed[4] = {1, 0, 0, 1}, kGreen[4] = {0, 1, 0, 1};

struct LateValueCase {
  const char* name;
  std::function<void(Gl gl, Answers& answers)> calls;
};

void depthTriangle(Gl gl, float depth) {
  gl.Begin(GL_TRIANGLES);
  gl.Vertex3f(-1, -1, depth), gl.Vertex3f(1, -1, depth), gl.Vertex3f(0, 1, depth + 0.1f);
  gl.End();
}

/// Vertices in a corner, with a colour at the last but one.
void cornerVertices(Gl gl, GLenum mode, const GLfloat* color) {
  gl.Begin(mode);
  gl.Vertex3f(0.9f, 0.9f, 0), gl.Vertex3f(0.9f, 0.8f, 0);
  gl.Color4fv(color), gl.Vertex3f(0.8f, 0.8f, 0.1f), gl.Vertex3f(0.8f, 0.9f, 0.1f);
  gl.End();
}

void middle(Gl gl, Answers& answers) {
  GLubyte pixel[4] = {};
  gl.ReadPixels(kLateValuesSize / 2, kLateValuesSize / 2, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
  answers.insert(answers.end(), pixel, pixel + 4);
}

void current(Gl gl, Answers& answers) {
  std::array<GLfloat, 4> v{};
  for (const GLenum name : {GL_CURRENT_COLOR, GL_CURRENT_NORMAL, GL_CURRENT_TEXTURE_COORDS})
    gl.GetFloatv(name, v.data()), answers.insert(answers.end(), v.begin(), v.end());
  for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION})
    gl.GetMaterialfv(GL_FRONT, name, v.data()), answers.insert(answers.end(), v.begin(), v.end());
}

void lightUp(Gl gl) {
  gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0), gl.Normal3f(0, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// Materials set in a rasterised primitive, then a traced primitive that uses them.
void materialInside(Gl gl, GLenum mode, Answers& answers) {
  lightUp(gl);
  gl.Materialfv(GL_FRONT, GL_DIFFUSE, kRed);
  depthTriangle(gl, 0.9f);
  gl.Begin(mode);
  gl.Vertex3f(0.9f, 0.9f, 0), gl.Materialfv(GL_FRONT, GL_DIFFUSE, kGreen);
  gl.Vertex3f(0.9f, 0.8f, 0), gl.Vertex3f(0.8f, 0.8f, 0);
  gl.End();
  gl.Disable(GL_COLOR_LOGIC_OP);
  depthTriangle(gl, 0), middle(gl, answers), current(gl, answers);
}

/// The same for colours that the material follows.
void colorInside(Gl gl, GLenum mode, Answers& answers) {
  lightUp(gl);
  gl.Enable(GL_COLOR_MATERIAL), gl.Color4fv(kRed);
  depthTriangle(gl, 0.9f);
  cornerVertices(gl, mode, kGreen);
  gl.Disable(GL_COLOR_LOGIC_OP);
  depthTriangle(gl, 0), middle(gl, answers), current(gl, answers);
}

/// glColorMaterial after a draw of `mode`, lit or not, with or without queries before it.
void modeChanges(Gl gl, GLenum mode, bool lit, bool asked, GLenum to, Answers& answers) {
  gl.Enable(GL_DEPTH_TEST);
  if (lit) lightUp(gl);
  gl.ColorMaterial(GL_FRONT, GL_DIFFUSE), gl.Enable(GL_COLOR_MATERIAL);
  cornerVertices(gl, mode, kGreen);
  if (asked) gl.GetError();
  gl.ColorMaterial(GL_FRONT, to), current(gl, answers);
  gl.Disable(GL_COLOR_MATERIAL), current(gl, answers);
  gl.Enable(GL_LIGHTING), gl.Color4fv(kRed), depthTriangle(gl, 0), middle(gl, answers);
}

/// glPopAttrib after a draw, with what may come between.
void popped(Gl gl, GLbitfield mask, int between, Answers& answers) {
  GLint depth = 0;
  gl.Enable(GL_DEPTH_TEST);
  gl.PushAttrib(mask);
  cornerVertices(gl, GL_TRIANGLES, kGreen);
  if (between & 1) gl.GetIntegerv(GL_ATTRIB_STACK_DEPTH, &depth);
  if (between & 2) gl.GetError();
  if (between & 4) gl.NewList(gl.GenLists(1), GL_COMPILE), gl.EndList();
  if (between & 8) gl.Enable(GL_NORMALIZE);
  gl.PopAttrib();
  if (between & 16) depthTriangle(gl, -0.5f), middle(gl, answers);
  current(gl, answers);
}

std::vector<LateValueCase> everyCase() {
  std::vector<LateValueCase> cases = {
      {"material in lines", [](Gl gl, Answers& a) { materialInside(gl, GL_LINE_STRIP, a); }},
      {"material in triangles of a logic operation",
       [](Gl gl, Answers& a) { gl.Enable(GL_COLOR_LOGIC_OP), materialInside(gl, GL_TRIANGLES, a); }},
      {"colour in lines", [](Gl gl, Answers& a) { colorInside(gl, GL_LINE_STRIP, a); }},
      {"colour in points", [](Gl gl, Answers& a) { colorInside(gl, GL_POINTS, a); }},
      {"colour in quads of a logic operation",
       [](Gl gl, Answers& a) { gl.Enable(GL_COLOR_LOGIC_OP), colorInside(gl, GL_QUADS, a); }},
      {"colour of a draw without colours is stored with it",
       [](Gl gl, Answers& a) {
         gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_COLOR_MATERIAL), gl.Color4fv(kGreen);
         depthTriangle(gl, 0), gl.ColorMaterial(GL_FRONT, GL_EMISSION), current(gl, a);
       }},
      {"a colour that no vertex had waits",
       [](Gl gl, Answers& a) {
         gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_COLOR_MATERIAL), depthTriangle(gl, 0);
         gl.Enable(GL_NORMALIZE), gl.Color4fv(kGreen), gl.ColorMaterial(GL_FRONT, GL_EMISSION);
         current(gl, a);
       }},
      {"what a called list draws with is stored",
       [](Gl gl, Answers& a) {
         gl.NewList(1, GL_COMPILE), cornerVertices(gl, GL_TRIANGLES, kGreen), gl.EndList();
         gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_COLOR_MATERIAL), gl.CallList(1);
         gl.ColorMaterial(GL_FRONT, GL_EMISSION), current(gl, a);
       }},
      {"what was set before a list is called is stored there",
       [](Gl gl, Answers& a) {
         gl.NewList(1, GL_COMPILE), gl.ColorMaterial(GL_FRONT, GL_EMISSION), gl.EndList();
         gl.Enable(GL_COLOR_MATERIAL), gl.Color4fv(kGreen), gl.CallList(1), current(gl, a);
       }},
      {"materials, too",
       [](Gl gl, Answers& a) {
         gl.NewList(1, GL_COMPILE), gl.Enable(GL_COLOR_MATERIAL), gl.EndList();
         gl.ColorMaterial(GL_FRONT, GL_DIFFUSE), gl.Materialfv(GL_FRONT, GL_DIFFUSE, kRed);
         gl.Color4fv(kGreen), gl.CallList(1), lightUp(gl), depthTriangle(gl, 0), middle(gl, a),
             current(gl, a);
       }},
  };
  for (int between = 0; between < 32; ++between)
    for (const unsigned mask : {unsigned{GL_CURRENT_BIT}, GL_ALL_ATTRIB_BITS, unsigned{GL_LIGHTING_BIT}})
      cases.push_back({"glPopAttrib", [=](Gl gl, Answers& a) { popped(gl, GLbitfield{mask}, between, a); }});
  for (int i = 0; i < 16; ++i)
    cases.push_back({"glColorMaterial", [=](Gl gl, Answers& a) {
                       modeChanges(gl, i & 1 ? GL_LINES : GL_TRIANGLES, i & 2, i & 4,
                                   i & 8 ? GL_SPECULAR : GL_AMBIENT, a);
                     }});
  return cases;
}

TEST(LateValues, AreThoseOfTheRealOne) {
  int number = 0;
  for (const LateValueCase& c : everyCase()) {
    Answers expected, ours;
    {
      const auto real = OsmesaContext::create({kLateValuesSize, kLateValuesSize});
      c.calls(real->real(), expected);
    }
    const TracedContext traced({kLateValuesSize, kLateValuesSize});
    c.calls(traced.gl(), ours);
    EXPECT_EQ(ours, expected) << c.name << ", number " << number;
    ++number;
  }
}

}  // namespace
}  // namespace gluray::test
