// Every way in which a program may send lines and points gives the same tubes and spheres.
#include "tests/reference/lines/lines_stage.h"

#include <GL/glext.h>

#include <array>
#include <vector>

namespace gluray::test {
namespace {

struct ColoredVertex {
  float position[3];
  float color[4];
};

// An open zigzag towards the viewer, whose colours change along it.
constexpr std::array<ColoredVertex, 5> kZigzag{{{{-1.5f, -1, -2.5f}, {1, 0, 0, 1}},
                                                {{-0.5f, 1, -2.2f}, {0, 1, 0, 1}},
                                                {{0.3f, -1, -2}, {0, 0, 1, 1}},
                                                {{0.8f, 0.9f, -1.8f}, {1, 1, 0, 1}},
                                                {{1.2f, -0.6f, -1.6f}, {1, 1, 1, 1}}}};
constexpr std::array<GLuint, 8> kSegments{0, 1, 1, 2, 2, 3, 3, 4};
constexpr std::array<GLuint, 10> kClosed{0, 1, 1, 2, 2, 3, 3, 4, 4, 0};

void send(const gl::RealGl& gl, const ColoredVertex& v) {
  gl.Color4fv(v.color);
  gl.Vertex3fv(v.position);
}

void beginEnd(const gl::RealGl& gl, GLenum mode) {
  gl.Begin(mode);
  for (const ColoredVertex& v : kZigzag) send(gl, v);
  gl.End();
}

void separate(const gl::RealGl& gl, const auto& numbers) {
  gl.Begin(GL_LINES);
  for (const GLuint i : numbers) send(gl, kZigzag[i]);
  gl.End();
}

void usePointers(const gl::RealGl& gl, const void* base) {
  const auto* at = static_cast<const std::byte*>(base);
  gl.EnableClientState(GL_VERTEX_ARRAY);
  gl.EnableClientState(GL_COLOR_ARRAY);
  gl.VertexPointer(3, GL_FLOAT, sizeof(ColoredVertex), at);
  gl.ColorPointer(4, GL_FLOAT, sizeof(ColoredVertex), at + offsetof(ColoredVertex, color));
}

GLuint lineBuffer(const gl::RealGl& gl, GLenum target, const void* data, size_t bytes) {
  GLuint name = 0;
  gl.GenBuffers(1, &name);
  gl.BindBuffer(target, name);
  gl.BufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
  return name;
}

struct LineWay {
  const char* name;
  DrawLines draw;
};

/// The same image from every way; all in one context state: width 6.
void expectAllEqual(const std::vector<LineWay>& ways) {
  const auto wide = [](const DrawLines& draw) {
    return [=](const gl::RealGl& gl) {
      gl.LineWidth(6), gl.PointSize(9);
      draw(gl);
    };
  };
  const LineImage first = drawnRound(wide(ways.front().draw));
  EXPECT_GT(first.coveredInAll(), 100);
  EXPECT_EQ(first.statistics.drawsRasterised, 0u);
  for (const LineWay& way : ways) {
    SCOPED_TRACE(way.name);
    const LineImage other = drawnRound(wide(way.draw));
    EXPECT_EQ(other.statistics.drawsRasterised, 0u);
    EXPECT_EQ(other.image.colors, first.image.colors);
    EXPECT_EQ(other.image.depths, first.image.depths);
  }
}

void inList(const gl::RealGl& gl, const DrawLines& draw) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  draw(gl);
  gl.EndList();
  gl.CallList(list);
}

std::vector<LineWay> waysOf(GLenum mode) {
  return {
      {"glBegin", [=](const gl::RealGl& gl) { beginEnd(gl, mode); }},
      {"list", [=](const gl::RealGl& gl) { inList(gl, [=](const gl::RealGl& g) { beginEnd(g, mode); }); }},
      {"client arrays",
       [=](const gl::RealGl& gl) {
         usePointers(gl, kZigzag.data());
         gl.DrawArrays(mode, 0, 5);
       }},
      {"client elements",
       [=](const gl::RealGl& gl) {
         const GLubyte order[] = {0, 1, 2, 3, 4};
         usePointers(gl, kZigzag.data());
         gl.DrawElements(mode, 5, GL_UNSIGNED_BYTE, order);
       }},
      {"buffers",
       [=](const gl::RealGl& gl) {
         const GLuint order[] = {0, 1, 2, 3, 4};
         lineBuffer(gl, GL_ARRAY_BUFFER, kZigzag.data(), sizeof kZigzag);
         lineBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, order, sizeof order);
         usePointers(gl, nullptr);
         gl.DrawElements(mode, 5, GL_UNSIGNED_INT, nullptr);
       }},
      {"list of arrays",
       [=](const gl::RealGl& gl) {
         inList(gl, [=](const gl::RealGl& g) {
           usePointers(g, kZigzag.data());
           g.DrawArrays(mode, 0, 5);
         });
       }},
  };
}

TEST(WaysOfLines, StripsEqualTheirSegments) {
  std::vector<LineWay> ways = waysOf(GL_LINE_STRIP);
  ways.push_back({"segments", [](const gl::RealGl& gl) { separate(gl, kSegments); }});
  expectAllEqual(ways);
}

TEST(WaysOfLines, LoopsEqualTheirSegments) {
  std::vector<LineWay> ways = waysOf(GL_LINE_LOOP);
  ways.push_back({"segments", [](const gl::RealGl& gl) { separate(gl, kClosed); }});
  expectAllEqual(ways);
}

TEST(WaysOfLines, Points) { expectAllEqual(waysOf(GL_POINTS)); }

/// Draws beyond the size of those that join runs become meshes of their own.
TEST(WaysOfLines, LargeArraysEqualSmallOnes) {
  constexpr int kTimes = 60;
  std::vector<GLuint> numbers;
  for (int i = 0; i < kTimes; ++i) numbers.insert(numbers.end(), kSegments.begin(), kSegments.end());
  const auto elements = [numbers](const gl::RealGl& gl) {
    usePointers(gl, kZigzag.data());
    gl.DrawElements(GL_LINES, static_cast<GLsizei>(numbers.size()), GL_UNSIGNED_INT, numbers.data());
  };
  const auto buffers = [numbers](const gl::RealGl& gl) {
    lineBuffer(gl, GL_ARRAY_BUFFER, kZigzag.data(), sizeof kZigzag);
    lineBuffer(gl, GL_ELEMENT_ARRAY_BUFFER, numbers.data(), numbers.size() * 4);
    usePointers(gl, nullptr);
    gl.DrawElements(GL_LINES, static_cast<GLsizei>(numbers.size()), GL_UNSIGNED_INT, nullptr);
  };
  expectAllEqual({{"separate", [](const gl::RealGl& gl) { separate(gl, kSegments); }},
                  {"elements", elements},
                  {"buffers", buffers}});
}

TEST(WaysOfLines, ColorsAreInterpolated) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    gl.LineWidth(9);
    gl.Begin(GL_LINES);
    gl.Color3f(1, 0, 0), gl.Vertex3f(-2, 0.03f, -2);
    gl.Color3f(0, 0, 1), gl.Vertex3f(2, 0.03f, -2);
    gl.End();
  });
  for (const int x : {10, 32, 54}) {
    const double share = (x + 0.5) / kLineStage;
    EXPECT_NEAR(round.channel(x, 32, 0), 255 * (1 - share), 8);
    EXPECT_NEAR(round.channel(x, 32, 2), 255 * share, 8);
  }
}

TEST(WaysOfLines, FlatShadingTakesTheLastVertex) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    gl.ShadeModel(GL_FLAT);
    gl.LineWidth(9);
    gl.Begin(GL_LINES);
    gl.Color3f(1, 0, 0), gl.Vertex3f(-2, 0.03f, -2);
    gl.Color3f(0, 0, 1), gl.Vertex3f(2, 0.03f, -2);
    gl.End();
  });
  EXPECT_EQ(round.channel(10, 32, 0), 0);
  EXPECT_GE(round.channel(10, 32, 2), 245);
}

TEST(WaysOfLines, WidthsHoldForTheLinesThatFollow) {
  const LineImage round = drawnRound([](const gl::RealGl& gl) {
    for (const float at : {-1.0f, 1.0f}) {
      gl.LineWidth(at < 0 ? 3 : 11);
      gl.Begin(GL_LINES);
      gl.Vertex3f(at, -2, -2), gl.Vertex3f(at, 2, -2);
      gl.End();
    }
  });
  int left = 0, right = 0;
  for (int x = 0; x < 32; ++x) left += round.covered(x, 32), right += round.covered(x + 32, 32);
  EXPECT_NEAR(left, 3, 1);
  EXPECT_NEAR(right, 11, 1);
}

}  // namespace
}  // namespace gluray::test
