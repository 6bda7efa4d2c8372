// All queryable state after a frame: the same values and errors with and without GLuRay.
#include "tests/support/gl_state.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gluray::test {
namespace {

constexpr int kStateWidth = 96, kStateHeight = 72;

/// Addresses differ from run to run, also without GLuRay.
bool isAddress(const std::string& line) {
  return line.find("pointer") != line.npos || line.find("POINTER") != line.npos;
}

class StateTest : public testing::TestWithParam<const scenes::Scene*> {};

TEST_P(StateTest, AnswersAreTheSame) {
  const auto real = OsmesaContext::create({kStateWidth, kStateHeight});
  GetParam()->draw(real->real(), kStateWidth, kStateHeight);
  const GlState expected = queryState(real->real());

  TracedContext ours({kStateWidth, kStateHeight});
  GetParam()->draw(ours.gl(), kStateWidth, kStateHeight);
  std::vector<std::string> lines = differences(expected, queryState(ours.gl()));
  std::erase_if(lines, isAddress);
  EXPECT_EQ(lines, std::vector<std::string>{});
}

std::vector<const scenes::Scene*> everyScene() {
  std::vector<const scenes::Scene*> all;
  for (const scenes::Scene& scene : scenes::scenes()) all.push_back(&scene);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Scenes, StateTest, testing::ValuesIn(everyScene()), [](const auto& info) {
  std::string name = info.param->name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

struct Misuse {
  const char* name;
  void (*calls)(scenes::Gl gl);
};

const Misuse kMisuses[] = {
    {"unknown capability", [](scenes::Gl gl) { gl.Enable(0xdead); }},
    {"unknown shade model", [](scenes::Gl gl) { gl.ShadeModel(GL_LINE); }},
    {"unknown primitive", [](scenes::Gl gl) { gl.Begin(77); }},
    {"end without begin", [](scenes::Gl gl) { gl.End(); }},
    {"begin within begin", [](scenes::Gl gl) { gl.Begin(GL_TRIANGLES), gl.Begin(GL_QUADS), gl.End(); }},
    {"enable within begin", [](scenes::Gl gl) { gl.Begin(GL_TRIANGLES), gl.Enable(GL_BLEND), gl.End(); }},
    {"draw within begin", [](scenes::Gl gl) { gl.Begin(GL_TRIANGLES), gl.DrawArrays(GL_TRIANGLES, 0, 3), gl.End(); }},
    {"clear within begin", [](scenes::Gl gl) { gl.Begin(GL_LINES), gl.Clear(GL_COLOR_BUFFER_BIT), gl.End(); }},
    {"matrix within begin", [](scenes::Gl gl) { gl.Begin(GL_POINTS), gl.LoadIdentity(), gl.End(); }},
    {"negative viewport", [](scenes::Gl gl) { gl.Viewport(0, 0, -1, 5); }},
    {"unknown clear bits", [](scenes::Gl gl) { gl.Clear(0x80000000); }},
    {"matrix stack underflow", [](scenes::Gl gl) { gl.PopMatrix(); }},
    {"matrix stack overflow", [](scenes::Gl gl) { for (int i = 0; i < 100; ++i) gl.PushMatrix(); }},
    {"attribute stack underflow", [](scenes::Gl gl) { gl.PopAttrib(); }},
    {"attribute stack overflow", [](scenes::Gl gl) { for (int i = 0; i < 40; ++i) gl.PushAttrib(GL_CURRENT_BIT); }},
    {"unknown light", [](scenes::Gl gl) { gl.Lightf(GL_LIGHT0 + 99, GL_SPOT_CUTOFF, 5); }},
    {"spot cutoff", [](scenes::Gl gl) { gl.Lightf(GL_LIGHT0, GL_SPOT_CUTOFF, 120); }},
    {"shininess", [](scenes::Gl gl) { gl.Materialf(GL_FRONT, GL_SHININESS, 200); }},
    {"material face", [](scenes::Gl gl) { gl.Materialf(GL_LINE, GL_SHININESS, 2); }},
    {"material name", [](scenes::Gl gl) { gl.Materialf(GL_FRONT, GL_DIFFUSE, 2); }},
    {"material within begin", [](scenes::Gl gl) { gl.Begin(GL_TRIANGLES), gl.Materialf(GL_FRONT, GL_SHININESS, 200), gl.End(); }},
    {"list 0", [](scenes::Gl gl) { gl.NewList(0, GL_COMPILE); }},
    {"list mode", [](scenes::Gl gl) { gl.NewList(5, GL_TRIANGLES); }},
    {"end of no list", [](scenes::Gl gl) { gl.EndList(); }},
    {"list within list", [](scenes::Gl gl) { gl.NewList(5, GL_COMPILE), gl.NewList(6, GL_COMPILE), gl.EndList(); }},
    {"negative list count", [](scenes::Gl gl) { gl.GenLists(-1); }},
    {"negative list range", [](scenes::Gl gl) { gl.DeleteLists(1, -1); }},
    {"lists of no type", [](scenes::Gl gl) { gl.CallLists(1, GL_DOUBLE, "a"); }},
    {"negative lists", [](scenes::Gl gl) { gl.CallLists(-1, GL_BYTE, "a"); }},
    {"no such list", [](scenes::Gl gl) { gl.CallList(4711); }},
    {"list within begin", [](scenes::Gl gl) { gl.Begin(GL_TRIANGLES), gl.NewList(9, GL_COMPILE), gl.End(); }},
    {"vertex size", [](scenes::Gl gl) { gl.VertexPointer(5, GL_FLOAT, 0, nullptr); }},
    {"vertex type", [](scenes::Gl gl) { gl.VertexPointer(3, GL_UNSIGNED_BYTE, 0, nullptr); }},
    {"negative stride", [](scenes::Gl gl) { gl.NormalPointer(GL_FLOAT, -4, nullptr); }},
    {"negative count", [](scenes::Gl gl) { gl.DrawArrays(GL_TRIANGLES, 0, -3); }},
    {"negative first", [](scenes::Gl gl) { gl.DrawArrays(GL_TRIANGLES, -1, 3); }},
    {"draw mode", [](scenes::Gl gl) { gl.DrawArrays(GL_FRONT, 0, 3); }},
    {"index type", [](scenes::Gl gl) { gl.DrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr); }},
    {"negative elements", [](scenes::Gl gl) { gl.DrawElements(GL_TRIANGLES, -3, GL_UNSIGNED_INT, nullptr); }},
    {"range upside down", [](scenes::Gl gl) { gl.DrawRangeElements(GL_TRIANGLES, 5, 2, 3, GL_UNSIGNED_INT, nullptr); }},
    {"interleaved format", [](scenes::Gl gl) { gl.InterleavedArrays(GL_FLOAT, 0, nullptr); }},
    {"buffer target", [](scenes::Gl gl) { gl.BindBuffer(GL_TEXTURE_2D, 1); }},
    {"no buffer bound", [](scenes::Gl gl) { gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW); }},
    {"negative buffer", [](scenes::Gl gl) { gl.BindBuffer(GL_ARRAY_BUFFER, 1), gl.BufferData(GL_ARRAY_BUFFER, -4, nullptr, GL_STATIC_DRAW); }},
    {"buffer usage", [](scenes::Gl gl) { gl.BindBuffer(GL_ARRAY_BUFFER, 1), gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_FRONT); }},
    {"beyond the buffer", [](scenes::Gl gl) { gl.BindBuffer(GL_ARRAY_BUFFER, 1), gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW), gl.BufferSubData(GL_ARRAY_BUFFER, 2, 4, "abcd"); }},
    {"mapped twice", [](scenes::Gl gl) {
       gl.BindBuffer(GL_ARRAY_BUFFER, 1), gl.BufferData(GL_ARRAY_BUFFER, 4, nullptr, GL_STATIC_DRAW);
       gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY), gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_ONLY);
     }},
    {"not mapped", [](scenes::Gl gl) { gl.BindBuffer(GL_ARRAY_BUFFER, 1), gl.UnmapBuffer(GL_ARRAY_BUFFER); }},
    {"texture target", [](scenes::Gl gl) { gl.BindTexture(GL_LIGHT0, 1); }},
    {"texture size", [](scenes::Gl gl) { gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, -1, 4, 0, GL_RGB, GL_FLOAT, nullptr); }},
    {"texture border", [](scenes::Gl gl) { gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 3, GL_RGB, GL_FLOAT, nullptr); }},
    {"texture filter", [](scenes::Gl gl) { gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_REPEAT); }},
    {"environment mode", [](scenes::Gl gl) { gl.TexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_LIGHT0); }},
    {"clip plane", [](scenes::Gl gl) { const GLdouble p[4] = {}; gl.ClipPlane(GL_CLIP_PLANE0 + 77, p); }},
    {"depth function", [](scenes::Gl gl) { gl.DepthFunc(GL_FRONT); }},
    {"cull face", [](scenes::Gl gl) { gl.CullFace(GL_LEFT); }},
    {"polygon mode", [](scenes::Gl gl) { gl.PolygonMode(GL_FRONT, GL_TRIANGLES); }},
    {"draw buffer", [](scenes::Gl gl) { gl.DrawBuffer(GL_LIGHT0); }},
    {"get name", [](scenes::Gl gl) { GLint v[16]; gl.GetIntegerv(GL_TRIANGLE_FAN + 0x5000, v); }},
    {"get within begin", [](scenes::Gl gl) { GLint v[16]; gl.Begin(GL_LINES), gl.GetIntegerv(GL_VIEWPORT, v), gl.End(); }},
    {"two errors, one flag", [](scenes::Gl gl) { gl.Enable(0xdead), gl.PopAttrib(), gl.Viewport(0, 0, -1, -1); }},
    {"frustum", [](scenes::Gl gl) { gl.Frustum(-1, 1, -1, 1, -1, 5); }},
    {"ortho", [](scenes::Gl gl) { gl.Ortho(1, 1, -1, 1, -1, 5); }},
    {"render mode", [](scenes::Gl gl) { gl.RenderMode(GL_FRONT); }},
    {"select without a buffer", [](scenes::Gl gl) { gl.RenderMode(GL_SELECT); }},
    {"misuse compiled into a list", [](scenes::Gl gl) {
       gl.NewList(7, GL_COMPILE), gl.ShadeModel(GL_LINE), gl.EndList();
       gl.CallList(7);
     }},
    {"lists that call themselves", [](scenes::Gl gl) {
       gl.NewList(8, GL_COMPILE), gl.CallList(8), gl.EndList();
       gl.CallList(8);
     }},
};

std::vector<GLenum> errorsOf(scenes::Gl gl, const Misuse& misuse) {
  misuse.calls(gl);
  std::vector<GLenum> errors;
  for (GLenum e = gl.GetError(); e != GL_NO_ERROR && errors.size() < 8; e = gl.GetError())
    errors.push_back(e);
  return errors;
}

TEST(Errors, AreThoseOfTheRealOne) {
  for (const Misuse& misuse : kMisuses) {
    const auto real = OsmesaContext::create({16, 16});
    const auto expected = errorsOf(real->real(), misuse);
    TracedContext ours({16, 16});
    EXPECT_EQ(errorsOf(ours.gl(), misuse), expected) << misuse.name;
    EXPECT_FALSE(ours.context().info().off) << misuse.name;
  }
}

}  // namespace
}  // namespace gluray::test
