// What happens at the ends of runs of glBegin and glEnd: state that changes there, primitives that the real
// OpenGL takes over, and runs that lists leave open.
#include "tests/reference/hostile/habits.h"
#include "tests/reference/triangle_field.h"

#include <GL/glext.h>

#include <array>
#include <cmath>
#include <vector>

namespace gluray::test::run_boundaries {
namespace {

using namespace twenty_points;

constexpr std::array<float, 4> kRedPaint{0.9f, 0.1f, 0.1f, 1}, kBluePaint{0.1f, 0.1f, 0.9f, 1};

void diffuse(Gl gl, const std::array<float, 4>& color) {
  gl.Materialfv(GL_FRONT_AND_BACK, GL_DIFFUSE, color.data());
  gl.Materialfv(GL_FRONT_AND_BACK, GL_AMBIENT, color.data());
}

void triangle(Gl gl, float x, float y = 0, float size = 0.4f) {
  gl.Vertex3f(x, y, 0.1f), gl.Vertex3f(x + size, y, 0), gl.Vertex3f(x, y + size, -0.1f);
}

/// Arrays of the field's triangles. Any other call than of a material or colour would end a run.
void arrays(Gl gl) {
  static const std::vector<float> positions = triangle_field::field(0.7f);
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, positions.data());
  gl.Normal3f(0, 0.3f, 0.95f);
}

void fieldFrom(Gl gl, int first, int count) { gl.DrawArrays(GL_TRIANGLES, 3 * first, 3 * count); }

TEST(RunBoundaries, MaterialBetweenASmallAndALargeArrayDraw) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    arrays(gl);
    diffuse(gl, kBluePaint), fieldFrom(gl, 0, 10);
    diffuse(gl, kRedPaint), fieldFrom(gl, 10, 90);
  });
}

TEST(RunBoundaries, MaterialBetweenBeginAndALargeArrayDraw) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    arrays(gl);
    diffuse(gl, kBluePaint);
    gl.Begin(GL_TRIANGLES), gl.Normal3f(0, 0, 1), triangle(gl, -0.9f, -1.3f), gl.End();
    diffuse(gl, kRedPaint), fieldFrom(gl, 0, 100);
  });
}

TEST(RunBoundaries, ColorMaterialBetweenASmallAndALargeArrayDraw) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.ColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE), gl.Enable(GL_COLOR_MATERIAL);
    arrays(gl);
    gl.Color3fv(kBluePaint.data()), fieldFrom(gl, 0, 10);
    gl.Color3fv(kRedPaint.data()), fieldFrom(gl, 10, 90);
  });
}

// --- Primitives with a vertex that is not captured

void evaluators(Gl gl) {
  constexpr GLfloat kCorners[] = {-0.9f, -0.8f, 0.3f, 0.9f, -0.8f, 0.3f, -0.9f, 0.8f, 0.2f, 0.9f, 0.8f, 0.2f};
  gl.Map2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, kCorners), gl.Enable(GL_MAP2_VERTEX_3);
}

void evaluatedStrip(Gl gl) {
  gl.Begin(GL_TRIANGLE_STRIP);
  for (int i = 0; i < 8; ++i) {
    const float u = 0.13f * static_cast<float>(i);
    gl.EvalCoord2f(u, 0.3f), gl.EvalCoord2f(u, 0.6f);
  }
  gl.End();
}

/// A framebuffer object of two textures, into which images may be sent after a clear.
void bindTextures(Gl gl) {
  GLuint names[2] = {}, framebuffer = 0;
  gl.GenTextures(2, names), gl.GenFramebuffers(1, &framebuffer);
  gl.BindTexture(GL_TEXTURE_2D, names[0]);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kWidth, kHeight, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.BindTexture(GL_TEXTURE_2D, names[1]);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, kWidth, kHeight, 0, GL_DEPTH_STENCIL,
                GL_UNSIGNED_INT_24_8, nullptr);
  for (const GLuint name : names) {
    gl.BindTexture(GL_TEXTURE_2D, name);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, names[0], 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, names[1], 0);
}

TEST(RunBoundaries, EvaluatedVerticesAreUnderAImageThatIsSentIntoTextures) {
  expectSame([](Gl gl, Seen&) {
    bindTextures(gl);
    evaluators(gl);
    stage(gl);
    gl.DepthFunc(GL_LEQUAL), gl.Disable(GL_LIGHTING);
    gl.Color3f(1, 1, 0), evaluatedStrip(gl);
    gl.Begin(GL_TRIANGLES), gl.Color3f(0, 1, 1), triangle(gl, -0.3f, -0.2f, 0.8f), gl.End();
  });
}

TEST(RunBoundaries, BlendedEvaluatedVerticesLieOverWhatWasDrawnBefore) {
  expectSame([](Gl gl, Seen&) {
    evaluators(gl);
    stage(gl);
    gl.Disable(GL_LIGHTING);
    gl.Begin(GL_TRIANGLES), gl.Color3f(0, 1, 1), triangle(gl, -0.9f, -0.8f, 1.6f), gl.End();
    gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.Begin(GL_TRIANGLES), gl.Color4f(1, 0, 0, 0.5f), gl.Vertex3f(-0.5f, -0.6f, 0.4f);
    gl.EvalCoord2f(0.9f, 0.2f), gl.EvalCoord2f(0.4f, 0.9f), gl.End();
    gl.Disable(GL_BLEND);
  });
}

TEST(RunBoundaries, RestartInsideBegin) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Disable(GL_LIGHTING);
    gl.Begin(GL_TRIANGLE_STRIP);
    gl.Color3f(1, 0.5f, 0);
    for (const float x : {-0.9f, 0.3f}) {
      if (x > 0) gl.PrimitiveRestartNV();
      gl.Vertex3f(x, -0.5f, 0.1f), gl.Vertex3f(x, 0.2f, 0), gl.Vertex3f(x + 0.4f, -0.4f, 0.2f),
          gl.Vertex3f(x + 0.4f, 0.4f, 0);
    }
    gl.End();
    gl.Begin(GL_TRIANGLES), triangle(gl, -0.2f, 0.4f), gl.End();
  });
}

// --- Long runs, which get a new attribute

void manyTriangles(Gl gl, float y) {
  for (int i = 0; i < 1700; ++i)
    triangle(gl, -0.9f + 0.001f * static_cast<float>(i), y + 0.0001f * static_cast<float>(i % 7), 0.05f);
}

TEST(RunBoundaries, MaterialOfALongRunThatGetsAnAttribute) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    diffuse(gl, kBluePaint);
    gl.Begin(GL_TRIANGLES), gl.Normal3f(0, 0.2f, 1), diffuse(gl, kRedPaint), manyTriangles(gl, 0.3f),
        gl.End();
    gl.TexCoord2f(0.5f, 0.5f);
    gl.Begin(GL_TRIANGLES), triangle(gl, -0.5f, -0.5f), gl.End();
  });
}

TEST(RunBoundaries, OutlinesAfterALongRunOfThem) {
  const auto draw = [](Gl gl, Seen&) {
    stage(gl);
    gl.Disable(GL_LIGHTING), gl.Color3f(0.2f, 0.5f, 1);
    gl.Begin(GL_TRIANGLES), triangle(gl, -0.5f, -0.5f, 0.9f), gl.End();
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE), gl.Color3f(1, 1, 1);
    gl.Begin(GL_TRIANGLES), manyTriangles(gl, 0.5f), gl.End();
    gl.TexCoord2f(0.5f, 0.5f);
    gl.Begin(GL_TRIANGLES), triangle(gl, -0.5f, -0.5f, 0.9f), gl.End();
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  };
  expectSame(draw, {.traced = 0});  // surfaces with outlines of their own are rasterised
}

// --- Lists

/// A list of three vertices, for callers between glBegin and glEnd.
GLuint looseTriangle(Gl gl) {
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE), triangle(gl, -0.9f), gl.EndList();
  return list;
}

struct Between {
  const char* name;
  void (*change)(Gl gl);
};
void PrintTo(const Between& b, std::ostream* out) { *out << b.name; }

class RunsOfLists : public testing::TestWithParam<Between> {};

TEST_P(RunsOfLists, EndAtChangesOfState) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Disable(GL_LIGHTING), gl.Color3f(1, 0.6f, 0.2f);
    const GLuint loose = looseTriangle(gl), list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    gl.Begin(GL_TRIANGLES), gl.CallList(loose), gl.End();
    GetParam().change(gl);
    gl.Begin(GL_TRIANGLES), gl.CallList(loose), gl.End();
    gl.EndList();
    gl.CallList(list);
    gl.Translatef(0.2f, -0.8f, 0);
    gl.Begin(GL_TRIANGLES), triangle(gl, 0), gl.End();
  });
}

const Between kBetween[] = {
    {"Translate", [](Gl gl) { gl.Translatef(1, 0.2f, 0); }},
    {"Light", [](Gl gl) { gl.Translatef(0.7f, 0, 0), gl.Enable(GL_LIGHTING); }},
    {"Clear", [](Gl gl) { gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), gl.Translatef(1, 0, 0); }},
    {"FragmentOfTheRealOne",
     [](Gl gl) {
       constexpr GLubyte kSquare[] = {255, 255, 255, 255, 255, 255, 255, 255};
       gl.RasterPos3f(-0.7f, 0.1f, 0.3f), gl.Color3f(0, 1, 0);
       gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1), gl.Bitmap(8, 8, 0, 0, 0, 0, kSquare);
     }},
};

INSTANTIATE_TEST_SUITE_P(All, RunsOfLists, testing::ValuesIn(kBetween),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(RunBoundaries, ColorAfterAnIncompletePrimitiveOfAList) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    gl.Disable(GL_LIGHTING);
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    gl.Begin(GL_TRIANGLES), gl.Vertex3f(-0.5f, -0.5f, 0), gl.Vertex3f(0.5f, -0.5f, 0);
    gl.Color3f(1, 0, 0), gl.End();
    gl.Begin(GL_TRIANGLES), triangle(gl, -0.4f, -0.3f, 0.8f), gl.End();
    gl.EndList();
    gl.Color3f(0, 1, 0), gl.CallList(list);
  });
}

TEST(RunBoundaries, EvaluatedVerticesOfAListWithTheCallersColor) {
  expectSame([](Gl gl, Seen&) {
    evaluators(gl);
    stage(gl);
    gl.Disable(GL_LIGHTING);
    const GLuint list = gl.GenLists(1);
    gl.NewList(list, GL_COMPILE);
    gl.Begin(GL_TRIANGLES), triangle(gl, -0.5f, -0.6f), gl.Color3f(1, 0, 0);
    gl.EvalCoord2f(0.9f, 0.2f), gl.EvalCoord2f(0.4f, 0.9f), gl.EvalCoord2f(0.1f, 0.8f), gl.End();
    gl.EndList();
    gl.Color3f(0, 1, 0), gl.CallList(list);
    gl.Begin(GL_TRIANGLES), triangle(gl, -0.9f, 0.3f), gl.End();
  });
}

// --- Buffers: calls that fail change nothing

TEST(RunBoundaries, StorageThatIsRefusedLeavesTheBuffer) {
  expectSame([](Gl gl, Seen&) {
    stage(gl);
    const std::vector<float> positions = triangle_field::field(0.7f);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, triangle_field::kBytes, positions.data(), GL_STATIC_DRAW);
    gl.BufferStorage(GL_ARRAY_BUFFER, 0, nullptr, 0);
    gl.BufferStorage(GL_ARRAY_BUFFER, 64, nullptr, 0x80000000u);
    gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
    gl.DrawArrays(GL_TRIANGLES, 0, triangle_field::kVertices);
  });
}

TEST(RunBoundaries, ErrorsOfMappings) {
  expectSame([](Gl gl, Seen& seen) {
    stage(gl);
    const std::vector<float> positions = triangle_field::field(0.7f);
    GLuint buffer = 0;
    gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, triangle_field::kBytes, positions.data(), GL_STATIC_DRAW);
    const auto error = [&] { seen.push_back(static_cast<float>(gl.GetError())); };
    constexpr GLbitfield kFlushed = GL_MAP_WRITE_BIT | GL_MAP_FLUSH_EXPLICIT_BIT;
    gl.MapBufferRange(GL_ARRAY_BUFFER, 0, 64, kFlushed), error();
    gl.FlushMappedBufferRange(GL_ARRAY_BUFFER, 32, 64), error();
    gl.FlushMappedBufferRange(GL_ARRAY_BUFFER, -4, 8), error();
    gl.FlushMappedBufferRange(GL_ARRAY_BUFFER, 4, -8), error();
    gl.FlushMappedBufferRange(GL_ARRAY_BUFFER, 0, 64), error();
    gl.BindBuffer(GL_COPY_WRITE_BUFFER, buffer);
    seen.push_back(gl.MapBufferRange(GL_COPY_WRITE_BUFFER, 0, 64, GL_MAP_WRITE_BIT) != nullptr), error();
    seen.push_back(gl.UnmapBuffer(GL_ARRAY_BUFFER)), error();
    seen.push_back(gl.UnmapBuffer(GL_ARRAY_BUFFER)), error();
    gl.BindBuffer(GL_COPY_WRITE_BUFFER, 0);
    gl.BufferSubData(GL_ARRAY_BUFFER, 0, triangle_field::kBytes, positions.data()), error();
    gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 0, nullptr);
    gl.DrawArrays(GL_TRIANGLES, 0, triangle_field::kVertices);
  });
}

}  // namespace
}  // namespace gluray::test::run_boundaries
