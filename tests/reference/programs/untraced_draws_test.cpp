// Many draws by programs that no family describes, one by one and as multi-draws.
#include "gl/buffers/buffer.h"
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

constexpr const char* kCountingShader = R"(#version 150
#extension GL_ARB_shader_draw_parameters : require
uniform vec2 shift;
in vec3 position;
flat out vec4 paint;
void main() {
  int i = gl_DrawIDARB;
  gl_Position = vec4(position.xy + shift + vec2(0.4 * i - 0.4, 0.0), position.z, 1.0);
  paint = vec4(i == 0, i == 1, i == 2, 1.0);
})";
constexpr const char* kPlainShader = R"(#version 150
uniform vec2 shift;
in vec3 position;
flat out vec4 paint;
void main() {
  gl_Position = vec4(position.xy + shift, position.z, 1.0);
  paint = vec4(0.5 + shift, 0.25 + 0.5 * position.z, 1.0);
})";
constexpr const char* kPaintShader = R"(#version 150
flat in vec4 paint;
out vec4 color;
void main() { color = paint; })";

/// `position` is its only attribute, at location 0.
GLuint makeOwnProgram(Gl gl, const char* vertexShader) { return makeProgram(gl, vertexShader, kPaintShader); }

/// Three triangles, one behind the other, with 16-bit indices.
void useTriangles(Gl gl) {
  const std::array<GLfloat, 27> corners{-0.2f, -0.3f, 0.1f, 0.2f, -0.3f, 0.1f, 0,     0.3f, 0.1f,  //
                                        -0.1f, -0.2f, 0.4f, 0.3f, -0.2f, 0.4f, 0.1f,  0.4f, 0.4f,
                                        -0.3f, -0.4f, 0.7f, 0.1f, -0.4f, 0.7f, -0.1f, 0.2f, 0.7f};
  const std::array<GLushort, 9> indices{0, 1, 2, 3, 4, 5, 6, 7, 8};
  std::array<GLuint, 2> buffers{};
  gl.GenBuffers(2, buffers.data());
  gl.BindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  gl.BufferData(GL_ARRAY_BUFFER, sizeof corners, corners.data(), GL_STATIC_DRAW);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indices, indices.data(), GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 12, nullptr);
}

const void* indexAt(size_t i) { return reinterpret_cast<const void*>(2 * i); }

void drawByMultiDraws(Gl gl, GLuint program) {
  const std::array<GLint, 3> first{0, 3, 6}, base{0, 0, -3};
  const std::array<GLsizei, 3> counts{3, 3, 3};
  const std::array<const void*, 3> indices{indexAt(0), indexAt(3), indexAt(6)};
  const auto shift = [&](float x, float y) { gl.Uniform2f(gl.GetUniformLocation(program, "shift"), x, y); };
  shift(-0.1f, 0.5f), gl.MultiDrawArrays(GL_TRIANGLES, first.data(), counts.data(), 3);
  shift(0, 0), gl.MultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_SHORT, indices.data(), 3);
  shift(0.1f, -0.5f);
  gl.MultiDrawElementsBaseVertex(GL_TRIANGLES, counts.data(), GL_UNSIGNED_SHORT, indices.data(), 3,
                                 base.data());
}

/// A compatibility profile of the highest version.
constexpr ContextWish kOld{kProgramWidth, kProgramHeight, false, 0, 0};

class UntracedDraws : public testing::TestWithParam<const char*> {};

TEST_P(UntracedDraws, AreTheSameOneByOneAndTogether) {
  const Outcome o = expectSame(
      "untraced_multi_draws",
      [&](Gl gl) {
        const GLuint program = makeOwnProgram(gl, GetParam());
        useTriangles(gl);
        for (int frame = 0; frame < 3; ++frame) {
          beginFrame(gl);
          gl.UseProgram(program);
          drawByMultiDraws(gl, program);
          for (int i = 0; i < 40; ++i) {
            gl.Uniform2f(gl.GetUniformLocation(program, "shift"), 0.02f * static_cast<float>(i % 7) - 0.6f,
                         0.04f * static_cast<float>(i) - 0.8f);
            gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, indexAt(static_cast<size_t>(i) % 3 * 3));
          }
          gl.UseProgram(0);
        }
      },
      0, kOld);
  EXPECT_GE(o.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::program)], 3u * 43u);
}

INSTANTIATE_TEST_SUITE_P(Shaders, UntracedDraws, testing::Values(kPlainShader, kCountingShader));

/// One stage of a pipeline.
GLuint makeSeparable(Gl gl, GLenum stage, std::string text) {
  text.replace(0, std::strlen("#version 150"), "#version 410");
  if (stage == GL_VERTEX_SHADER)
    text.insert(text.find("uniform"), "out gl_PerVertex { vec4 gl_Position; };\n");
  for (const char* declared : {"in vec3 position", "flat "})
    if (const size_t at = text.find(declared); at != std::string::npos)
      text.insert(at, "layout(location = 0) ");
  const char* const source = text.c_str();
  const GLuint program = gl.CreateShaderProgramv(stage, 1, &source);
  GLint linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  EXPECT_TRUE(linked);
  return program;
}

TEST(UntracedDrawsAmongOthers, AreNumberedInPipelines) {
  const Outcome o = expectSame(
      "untraced_pipeline",
      [](Gl gl) {
        const GLuint vertex = makeSeparable(gl, GL_VERTEX_SHADER, kCountingShader);
        const GLuint fragment = makeSeparable(gl, GL_FRAGMENT_SHADER, kPaintShader);
        GLuint pipeline = 0, array = 0;
        gl.GenVertexArrays(1, &array), gl.BindVertexArray(array), useTriangles(gl);
        gl.GenProgramPipelines(1, &pipeline);
        gl.UseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, vertex);
        gl.UseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, fragment);
        gl.ActiveShaderProgram(pipeline, vertex);
        beginFrame(gl);
        gl.UseProgram(0), gl.BindProgramPipeline(pipeline);
        drawByMultiDraws(gl, vertex);
        gl.BindProgramPipeline(0), gl.BindVertexArray(0);
      },
      0, coreWish(4, 5));
  EXPECT_EQ(o.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::program)], 3u);
}

/// The last of three frames is too large for the real OpenGL alone, to which it was left up to this draw.
TEST(UntracedDrawsAmongOthers, AreNumberedWhereTheyEndAPassthroughFrame) {
  constexpr size_t kCorners = 30000;
  const auto drawn = [](Gl gl, const std::function<bool()>& passesThrough) {
    const std::array<GLsizei, 3> counts{kCorners, kCorners, kCorners};
    const std::array<const void*, 3> starts{};
    std::vector<GLushort> indices;
    for (size_t i = 0; i < kCorners; ++i) indices.push_back(static_cast<GLushort>(i % 3));
    const GLuint program = makeOwnProgram(gl, kCountingShader);
    useTriangles(gl);
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 2 * kCorners, indices.data(), GL_STATIC_DRAW);
    gl.UseProgram(program);
    for (int frame = 0; frame < 2; ++frame) beginFrame(gl), gl.DrawArrays(GL_TRIANGLES, 0, 9), gl.Finish();
    beginFrame(gl);
    EXPECT_TRUE(passesThrough());
    gl.MultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_SHORT, starts.data(), 3);
    return readImage(gl, kProgramWidth, kProgramHeight);
  };
  const auto real = OsmesaContext::create(kOld);
  const DrawnImage expected = drawn(real->real(), [] { return true; });
  Settings settings = TracedContext::tracing();
  settings.engine = Engine::automatic;
  TracedContext ours(kOld, settings);
  const DrawnImage got = drawn(ours.gl(), [&] { return ours.context().clock.passesThrough(); });
  EXPECT_TRUE(got == expected);
  EXPECT_EQ(ours.context().counts.statistics.drawsRasterised, 3u);
}

/// Traced surfaces wait until something is drawn that needs them, and before that draw they are shown.
TEST(UntracedDrawsAmongOthers, MeetTracedSurfaces) {
  expectSame(
      "untraced_among_traced",
      [&](Gl gl) {
        const ProgramMesh round = ball(24);
        const GLuint program = makeProgram(gl, Surface{}), own = makeOwnProgram(gl, kPlainShader);
        const Upload up = upload(gl, round, program);
        GLuint array = 0;
        gl.GenVertexArrays(1, &array), gl.BindVertexArray(array), useTriangles(gl), gl.BindVertexArray(0);
        for (int frame = 0; frame < 3; ++frame) {
          beginFrame(gl);
          if (frame != 1) drawSurface(gl, program, up, round, perspectiveView(20), {});
          gl.UseProgram(own), gl.BindVertexArray(array);
          drawByMultiDraws(gl, own);
          gl.DrawArrays(GL_TRIANGLES, 0, 9);
          gl.UseProgram(0), gl.BindVertexArray(0);
          if (frame == 1) drawSurface(gl, program, up, round, perspectiveView(20), {});
        }
      },
      3, kOld);
}

/// Each draw's vertices are written behind those of the draw before, then the whole is traced.
TEST(UntracedDrawsAmongOthers, ReadWhatIsStreamed) {
  constexpr GLsizeiptr kSize = 1 << 20, kTriangle = 36;
  for (const bool mapped : {false, true}) {
    uint64_t sent = 0;
    expectSame(
        mapped ? "untraced_stream_mapped" : "untraced_stream",
        [&](Gl gl) {
          const GLuint own = makeOwnProgram(gl, kPlainShader);
          GLuint buffer = 0;
          gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
          gl.BufferData(GL_ARRAY_BUFFER, kSize, nullptr, GL_STREAM_DRAW);
          gl.EnableVertexAttribArray(0), gl.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 12, nullptr);
          beginFrame(gl);
          const uint64_t before = gl::Buffer::bytesSent();
          for (int i = 0; i < 60; ++i) {
            const float x = 0.03f * static_cast<float>(i) - 0.9f, z = 0.01f * static_cast<float>(i);
            const std::array<GLfloat, 9> corners{x, -0.5f, z, x + 0.2f, -0.5f, z, x, 0.6f, z};
            const GLintptr at = kTriangle * i;
            void* const memory =
                mapped ? gl.MapBufferRange(GL_ARRAY_BUFFER, at, kTriangle, GL_MAP_WRITE_BIT) : nullptr;
            if (memory)
              std::memcpy(memory, corners.data(), kTriangle), gl.UnmapBuffer(GL_ARRAY_BUFFER);
            else
              gl.BufferSubData(GL_ARRAY_BUFFER, at, kTriangle, corners.data());
            gl.UseProgram(own);
            gl.DrawArrays(GL_TRIANGLES, 3 * i, 3);
          }
          sent = gl::Buffer::bytesSent() - before;
          gl.UseProgram(0), gl.DisableVertexAttribArray(0);
          gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(3, GL_FLOAT, 12, nullptr);
          gl.Color3f(1, 0.5f, 0), gl.Translatef(0, 0.3f, -0.2f);
          gl.DrawArrays(GL_TRIANGLES, 0, 180);
          const std::array<GLfloat, 9> last{-0.9f, -0.9f, -0.5f, 0.9f, -0.9f, -0.5f, 0, -0.7f, -0.5f};
          gl.BufferSubData(GL_ARRAY_BUFFER, 0, kTriangle, last.data());
          gl.DrawArrays(GL_TRIANGLES, 0, 3);
          gl.DisableClientState(GL_VERTEX_ARRAY), gl.LoadIdentity(), gl.Color3f(1, 1, 1);
        },
        -1, kOld);
    EXPECT_LE(sent, 4u * kSize) << "the whole buffer was not sent for each draw";
  }
}

/// An error of the program's stays, whatever has to be found out about a program that draws for the first
/// time.
TEST(UntracedDrawsAmongOthers, LeaveEarlierErrors) {
  const Outcome o = expectSame(
      "untraced_earlier_error",
      [&](Gl gl) {
        const ProgramMesh round = ball(24);
        const GLuint program = makeProgram(gl, Surface{}), own = makeOwnProgram(gl, kPlainShader);
        const Upload up = upload(gl, round, program);
        beginFrame(gl);
        drawSurface(gl, program, up, round, perspectiveView(20), {});  // waits
        gl.UseProgram(own);
        gl.Enable(0xFFFF);
        gl.Begin(GL_TRIANGLES), gl.Vertex3f(-0.5f, -0.5f, 0), gl.Vertex3f(0.5f, -0.5f, 0);
        gl.Vertex3f(0, 0.5f, 0), gl.End();
        EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_ENUM));
        gl.UseProgram(0);
      },
      -1, kOld);
  EXPECT_GT(o.statistics.drawsTraced, 0u);
}

/// Errors and empty draws are those of the real OpenGL.
TEST(UntracedDrawsAmongOthers, RaiseErrors) {
  const auto errors = [](Gl gl) {
    std::vector<GLenum> raised;
    const GLuint program = makeOwnProgram(gl, kPlainShader);
    useTriangles(gl);
    beginFrame(gl);
    gl.UseProgram(program);
    const GLint first[2] = {0, 3};
    const GLsizei counts[2] = {3, 3}, wrong[2] = {3, -1};
    const void* const indices[2] = {indexAt(0), indexAt(3)};
    gl.DrawArrays(GL_TRIANGLES, 0, 9), raised.push_back(gl.GetError());
    gl.MultiDrawArrays(GL_TRIANGLES, first, wrong, 2), raised.push_back(gl.GetError());
    gl.MultiDrawArrays(0x77, first, counts, 2), raised.push_back(gl.GetError());
    gl.MultiDrawArrays(GL_TRIANGLES, first, counts, -1), raised.push_back(gl.GetError());
    gl.MultiDrawElements(GL_TRIANGLES, counts, GL_FLOAT, indices, 2), raised.push_back(gl.GetError());
    gl.MultiDrawElements(GL_TRIANGLES, counts, GL_UNSIGNED_SHORT, indices, 0),
        raised.push_back(gl.GetError());
    gl.UseProgram(0);
    return raised;
  };
  std::vector<std::vector<GLenum>> all;
  expectSame(
      "untraced_errors", [&](Gl gl) { all.push_back(errors(gl)); }, 0, kOld);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0], all[1]);
}

}  // namespace
}  // namespace gluray::test
