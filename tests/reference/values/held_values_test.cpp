// Current values and materials while GL_COLOR_MATERIAL is on or changes, after draws that are traced: Mesa
// stores values later than they are set, and programs see when. They must see the same through GLuRay.
#include "gl/real/extensions.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;

constexpr GLfloat kRed[4] = {1, 0, 0, 1}, kGreen[4] = {0, 1, 0, 1}, kBlue[4] = {0, 0, 1, 1};

constexpr std::array<GLfloat, 27> kCorners = {-1, -1, 0.3f, 1, -1, 0.2f, 0, 1, 0.1f,  //
                                              -1, -1, 0.5f, 1, -1, 0.4f, 0, 1, 0.3f,  //
                                              -1, -1, 0.7f, 1, -1, 0.6f, 0, 1, 0.5f};

/// Draws triangles from arrays: few, which join runs of glBegin, or more.
void drawArrays(Gl gl, bool few = true) {
  std::vector<GLfloat> corners;
  for (int i = 0; i < (few ? 1 : 100); ++i) corners.insert(corners.end(), kCorners.begin(), kCorners.end());
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, corners.data());
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(corners.size() / 3));
  gl.DisableClientState(GL_VERTEX_ARRAY);
}

void drawBegun(Gl gl, const GLfloat* color = nullptr) {
  gl.Begin(GL_TRIANGLES);
  if (color) gl.Color4fv(color);
  for (size_t i = 0; i < kCorners.size(); i += 3) gl.Vertex3fv(kCorners.data() + i);
  gl.End();
}

struct HeldCase {
  const char* name;
  void (*calls)(Gl gl);
  int before = 9900;  // the first version of Mesa that leaves other values, which GLuRay does not follow
};
void PrintTo(const HeldCase& c, std::ostream* out) { *out << c.name; }

const HeldCase kHeldCases[] = {
    {"colours before and after a change of state",
     [](Gl gl) {
       gl.Color4fv(kRed), gl.ColorMaterial(GL_FRONT, GL_EMISSION), gl.Color4fv(kGreen);
       gl.Translatef(0.1f, 0, 0), gl.ColorMaterial(GL_FRONT_AND_BACK, GL_DIFFUSE);
     }},
    {"a colour after few triangles from arrays",
     [](Gl gl) {
       gl.Color4fv(kRed), drawArrays(gl), gl.Color4fv(kGreen), gl.ColorMaterial(GL_BACK, GL_SPECULAR);
     }},
    {"a colour after many triangles from arrays",
     [](Gl gl) {
       gl.Color4fv(kRed), drawArrays(gl, false), gl.Color4fv(kGreen), gl.ColorMaterial(GL_BACK, GL_SPECULAR);
     }},
    {"several colours and draws, then another mode",
     [](Gl gl) {
       for (const GLfloat* color : {kRed, kGreen, kBlue}) gl.Color4fv(color), drawArrays(gl);
       gl.Color4fv(kRed), gl.ColorMaterial(GL_FRONT, GL_AMBIENT), drawArrays(gl);
     }},
    {"a colour that nothing draws with before another mode",
     [](Gl gl) {
       gl.ColorMaterial(GL_BACK, GL_SPECULAR), gl.Color4fv(kRed), gl.ColorMaterial(GL_FRONT, GL_EMISSION);
     }},
    {"the same mode again",
     [](Gl gl) {
       gl.Color4fv(kRed), gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
       gl.Enable(GL_COLOR_MATERIAL), gl.ColorMaterial(GL_FRONT, GL_EMISSION);
     }},
    {"a colour after glBegin and glEnd",
     [](Gl gl) {
       drawBegun(gl, kRed), gl.Color4fv(kGreen), gl.ShadeModel(GL_FLAT),
           gl.ColorMaterial(GL_BACK, GL_DIFFUSE);
     }},
    {"a list that sets a colour before and between glBegin and glEnd",
     [](Gl gl) {
       gl.NewList(1, GL_COMPILE), gl.Color4fv(kRed), drawBegun(gl, kGreen), gl.EndList();
       gl.CallList(1), gl.Translatef(0, 0.1f, 0);
     }},
    {"a list of draws from arrays",
     [](Gl gl) {
       gl.NewList(1, GL_COMPILE), drawArrays(gl), gl.Color4fv(kRed), drawBegun(gl, kGreen), gl.EndList();
       gl.Color4fv(kBlue), gl.CallList(1), gl.ColorMaterial(GL_BACK, GL_EMISSION);
     }},
    {"a list that is compiled and executed",
     [](Gl gl) {
       gl.NewList(1, GL_COMPILE_AND_EXECUTE), gl.Color4fv(kRed), drawBegun(gl, kGreen), gl.EndList();
       gl.ColorMaterial(GL_FRONT, GL_SPECULAR);
     }},
    {"a list that does not exist",
     [](Gl gl) { gl.Color4fv(kRed), gl.CallList(77), gl.ColorMaterial(GL_BACK, GL_EMISSION); }},
    {"glPopAttrib after a colour that follows a draw",
     [](Gl gl) {
       gl.PushAttrib(GL_CURRENT_BIT | GL_LIGHTING_BIT), gl.Color4fv(kRed), drawArrays(gl),
           gl.Color4fv(kGreen);
       gl.PopAttrib();
     }},
    {"glMaterial after glPushAttrib and glPushMatrix",
     [](Gl gl) {
       gl.Color4fv(kRed), drawArrays(gl), gl.PushAttrib(GL_LIGHTING_BIT), gl.PushMatrix();
       gl.Materialfv(GL_FRONT, GL_EMISSION, kGreen), gl.Translatef(0, 0.1f, 0), gl.PopMatrix(),
           gl.PopAttrib();
     }},
    {"glPopAttrib after a material, draws and a colour",
     [](Gl gl) {
       gl.PushAttrib(GL_CURRENT_BIT | GL_LIGHTING_BIT), gl.Materialfv(GL_FRONT, GL_EMISSION, kGreen);
       drawArrays(gl, false), gl.Color4fv(kRed), gl.PopAttrib();
     }},
    {"glPopAttrib in a list that is compiled and executed, after draws from arrays",
     [](Gl gl) {
       gl.Color4fv(kRed), gl.NewList(1, GL_COMPILE_AND_EXECUTE), gl.PushAttrib(GL_CURRENT_BIT);
       gl.Color4fv(kBlue), drawArrays(gl), gl.Color4fv(kGreen), gl.PopAttrib(), gl.EndList();
     }},
    {"glPopAttrib after a list of glMultiDrawArrays",
     [](Gl gl) {
       const GLint firsts[] = {0, 90};
       const GLsizei counts[] = {90, 90};
       std::vector<GLfloat> corners;
       for (int i = 0; i < 20; ++i) corners.insert(corners.end(), kCorners.begin(), kCorners.end());
       gl.PushAttrib(GL_CURRENT_BIT | GL_LIGHTING_BIT), gl.NewList(1, GL_COMPILE), gl.Color4fv(kRed);
       gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, corners.data());
       gl.MultiDrawArrays(GL_TRIANGLES, firsts, counts, 2), gl.DisableClientState(GL_VERTEX_ARRAY);
       gl.Color4fv(kGreen), gl.EndList(), gl.CallList(1), gl.PopAttrib();
     }},
    {"glPopAttrib in a list that is called after a material",
     [](Gl gl) {
       gl.NewList(1, GL_COMPILE), gl.PushAttrib(GL_CURRENT_BIT), gl.Color4fv(kRed), gl.PopAttrib();
       gl.EndList(), drawArrays(gl), gl.Materialfv(GL_FRONT_AND_BACK, GL_EMISSION, kGreen);
       gl.CallList(1), gl.Translatef(0, 0.1f, 0);
     }},
    {"colours of glArrayElement in a primitive that is rasterised",
     [](Gl gl) {
       const std::vector<GLfloat> colors(12, 0.5f);
       drawBegun(gl, kRed), gl.Disable(GL_DEPTH_TEST);
       gl.EnableClientState(GL_COLOR_ARRAY), gl.ColorPointer(4, GL_FLOAT, 0, colors.data());
       gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, kCorners.data());
       gl.Begin(GL_TRIANGLES), gl.ArrayElement(0), gl.ArrayElement(1), gl.ArrayElement(2), gl.End();
       gl.DisableClientState(GL_COLOR_ARRAY);
       gl.Materialfv(GL_FRONT, GL_EMISSION, kGreen), drawBegun(gl), gl.Translatef(0, 0.1f, 0);
     }},
    {"glPopAttrib after a colour that follows draws",
     [](Gl gl) {
       gl.PushAttrib(GL_LIGHTING_BIT), gl.Color4fv(kRed), drawArrays(gl, false), drawArrays(gl, false);
       gl.Color4fv(kGreen), gl.PopAttrib();
     }},
    {"materials and draws, without a colour that they follow",
     [](Gl gl) {
       gl.Disable(GL_COLOR_MATERIAL);
       for (const GLfloat* color : {kRed, kGreen})
         gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, color), drawArrays(gl, false);
       gl.Materialfv(GL_FRONT, GL_EMISSION, kBlue), drawBegun(gl), gl.Enable(GL_COLOR_MATERIAL);
       gl.Color4fv(kRed), drawArrays(gl);
     }},
    {"colours that follow draws, after glPopAttrib of another material",
     [](Gl gl) {
       gl.Color4fv(kRed), gl.PushAttrib(GL_LIGHTING_BIT), gl.Color4fv(kGreen), drawArrays(gl), gl.PopAttrib();
       drawArrays(gl), gl.Color4fv(kRed), drawArrays(gl), gl.Color4fv(kGreen), drawArrays(gl);
     }},
    {"a material that is held back, before colours",
     [](Gl gl) {
       gl.Disable(GL_COLOR_MATERIAL), gl.Color4fv(kRed), drawArrays(gl), drawArrays(gl, false);
       gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, kBlue), gl.Enable(GL_COLOR_MATERIAL);
       gl.Color4fv(kGreen), drawArrays(gl), gl.Color4fv(kRed), drawArrays(gl, false);
     }},
    {"the same colour before and in glBegin and glEnd, and another mode",
     [](Gl gl) {
       gl.Color4fv(kRed), drawBegun(gl, kRed), gl.Translatef(0.1f, 0, 0);
       drawBegun(gl, kRed), gl.Color4fv(kRed), gl.ColorMaterial(GL_FRONT, GL_EMISSION), drawBegun(gl, kRed);
     }},
    {"glPopAttrib of all after a material that follows a primitive, which is rasterised, and a traced draw",
     [](Gl gl) {
       drawArrays(gl, false), gl.PushAttrib(GL_ALL_ATTRIB_BITS), gl.DepthFunc(GL_GEQUAL), drawBegun(gl);
       gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, kBlue), gl.PopAttrib();
     }},
    {"the same in a list",
     [](Gl gl) {
       gl.NewList(1, GL_COMPILE), gl.PushAttrib(GL_ALL_ATTRIB_BITS), drawBegun(gl);
       gl.Materialfv(GL_FRONT_AND_BACK, GL_SPECULAR, kBlue), gl.PopAttrib(), gl.EndList();
       drawArrays(gl, false), gl.CallList(1), gl.Translatef(0, 0.1f, 0);
     }},
    {"a colour after a primitive without colours, which is rasterised",
     [](Gl gl) {
       gl.Color4fv(kRed), gl.ColorMaterial(GL_FRONT_AND_BACK, GL_EMISSION), gl.DepthFunc(GL_GEQUAL);
       drawBegun(gl), gl.Color4fv(kGreen), gl.ColorMaterial(GL_FRONT, GL_AMBIENT), gl.DepthFunc(GL_LESS);
     }},
    {"a list whose primitives have colours of their own, set before them",
     [](Gl gl) {
       gl.NewList(1, GL_COMPILE);
       for (const GLfloat* color : {kRed, kGreen, kBlue}) gl.Color4fv(color), drawBegun(gl);
       gl.EndList(), gl.CallList(1), gl.Translatef(0, 0.1f, 0), gl.ColorMaterial(GL_FRONT, GL_SPECULAR);
       gl.CallList(1), gl.Color4fv(kGreen), gl.Translatef(0, 0.1f, 0);
     }},
    {"a list that is called while another one is compiled and executed",
     [](Gl gl) {
       gl.NewList(1, GL_COMPILE), gl.Color4fv(kRed), drawBegun(gl, kGreen), gl.PushAttrib(GL_CURRENT_BIT);
       drawArrays(gl), gl.Color4fv(kBlue), gl.PopAttrib(), gl.EndList();
       gl.NewList(2, GL_COMPILE_AND_EXECUTE), gl.CallList(1), gl.EndList();
       gl.ColorMaterial(GL_FRONT, GL_SPECULAR);
     },
     2400},
    {"a primitive after a draw from arrays, without a change of state",
     [](Gl gl) {
       gl.Color4fv(kRed), drawArrays(gl, false), drawBegun(gl), gl.Color4fv(kGreen), drawBegun(gl, kBlue);
       gl.ColorMaterial(GL_BACK, GL_SPECULAR);
     }},
    {"a primitive right after a draw from arrays without arrays that change",
     [](Gl gl) {
       gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, kCorners.data());
       gl.Color4fv(kRed), gl.DrawArrays(GL_TRIANGLES, 0, 9), drawBegun(gl, kGreen);
       gl.DrawArrays(GL_TRIANGLES, 0, 9), gl.Color4fv(kBlue), gl.ColorMaterial(GL_BACK, GL_SPECULAR);
       gl.DrawArrays(GL_TRIANGLES, 0, 0), gl.Color4fv(kRed), gl.ColorMaterial(GL_BACK, GL_EMISSION);
       gl.DisableClientState(GL_VERTEX_ARRAY);
     }},
};

struct SeenValues {
  std::vector<GLfloat> values;
  DrawnImage image;
};

SeenValues seen(Gl gl, const HeldCase& c, int size) {
  gl.Enable(GL_LIGHTING), gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_LIGHT0), gl.Enable(GL_COLOR_MATERIAL);
  gl.Materialf(GL_FRONT_AND_BACK, GL_SHININESS, 8);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  c.calls(gl);
  SeenValues result;
  const auto keep = [&](const GLfloat* v) { result.values.insert(result.values.end(), v, v + 4); };
  gl.Translatef(0, 0, -0.2f);
  for (const GLenum face : {GL_FRONT, GL_BACK})
    for (const GLenum name : {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION}) {
      GLfloat v[4] = {};
      gl.GetMaterialfv(face, name, v), keep(v);
    }
  GLfloat color[4] = {};
  gl.GetFloatv(GL_CURRENT_COLOR, color);
  result.values.insert(result.values.begin(), color, color + 4);
  drawArrays(gl);
  result.image = readImage(gl, size, size);
  return result;
}

class HeldValues : public testing::TestWithParam<HeldCase> {};

TEST_P(HeldValues, AreThoseOfTheRealOpenGl) {
  constexpr int kSize = 32;
  const auto real = OsmesaContext::create({kSize, kSize});
  if (gl::mesaVersionOf(real->real().GetString(GL_VERSION)) >= GetParam().before) return;
  const SeenValues expected = seen(real->real(), GetParam(), kSize);
  const TracedContext ours({kSize, kSize});
  const SeenValues got = seen(ours.gl(), GetParam(), kSize);
  EXPECT_EQ(got.values, expected.values);
  const Comparison c = compare(expected.image, got.image, {});
  EXPECT_TRUE(c.accepted) << c.text;
  EXPECT_GT(ours.context().counts.statistics.drawsTraced, 0u);
}

INSTANTIATE_TEST_SUITE_P(Cases, HeldValues, testing::ValuesIn(kHeldCases));

}  // namespace
}  // namespace gluray::test
