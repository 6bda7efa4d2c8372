// Calls that GLuRay makes on its own account must not change what the real OpenGL draws for the program next:
// pairs of primitives without a state change between them, in framebuffers and with programs for which
// glBegin may fail.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/program_stage.h"
#include "tests/support/traced_context.h"

#include <GL/glext.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace gluray::test::own_calls {
namespace {

constexpr int kSize = 48;
constexpr GLenum kModes[] = {GL_POINTS,         GL_LINES,        GL_LINE_LOOP, GL_LINE_STRIP, GL_TRIANGLES,
                             GL_TRIANGLE_STRIP, GL_TRIANGLE_FAN, GL_QUADS,     GL_QUAD_STRIP, GL_POLYGON};

enum class Into { window, windowByProgram, renderbuffers, texture };
enum class Sent { begin, arrays };

struct Habit {
  Into into;
  Sent first, second;
  bool colorBetween = false;
  bool colorAfter = false;  // a current value that is set and never used
};

/// Four corners of a square from x on; strips take the last two in the other order.
void primitive(Gl gl, GLenum mode, Sent sent, float x) {
  const bool strip = mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP;
  const GLfloat corners[] = {x,   -0.5f, x + 0.6f, -0.5f, strip ? x : x + 0.6f, 0.5f, strip ? x + 0.6f : x,
                             0.5f};
  const GLsizei count = mode == GL_TRIANGLES ? 3 : 4;
  if (sent == Sent::arrays) {
    gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(2, GL_FLOAT, 0, corners);
    gl.DrawArrays(mode, 0, count), gl.DisableClientState(GL_VERTEX_ARRAY);
    return;
  }
  gl.Begin(mode);
  for (GLsizei i = 0; i < count; ++i) gl.Vertex2fv(corners + 2 * i);
  gl.End();
}

void bindTexture(Gl gl) {
  GLuint framebuffer = 0, color = 0, depth = 0;
  gl.GenTextures(1, &color), gl.BindTexture(GL_TEXTURE_2D, color);
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR), gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.GenRenderbuffers(1, &depth), gl.BindRenderbuffer(GL_RENDERBUFFER, depth);
  gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, kSize, kSize);
  gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
  gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth);
  ASSERT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
}

void prepare(Gl gl, Into into) {
  if (into == Into::renderbuffers)
    bindNewFramebuffer(gl, {kSize, kSize}, GL_RGBA8, GL_DEPTH24_STENCIL8);
  else if (into == Into::texture)
    bindTexture(gl);
  else if (into == Into::windowByProgram)
    gl.UseProgram(makeProgram(gl, "#version 120\nvoid main() { gl_Position = gl_Vertex; }",
                              "#version 120\nvoid main() { gl_FragColor = vec4(0.1, 0.2, 0.3, 1.0); }"));
  gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST), gl.ClearColor(1, 1, 0.9f, 1);
}

std::vector<uint32_t> pair(Gl gl, const Habit& habit, GLenum first, GLenum second) {
  gl.Color3f(0, 0, 0);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  primitive(gl, first, habit.first, -0.8f);
  if (habit.colorBetween) gl.Color3f(0.2f, 0, 0.1f);
  primitive(gl, second, habit.second, 0.2f);
  if (habit.colorAfter) gl.Color3f(0, 0, 0.02f);
  std::vector<uint32_t> pixels(kSize * kSize);
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

std::vector<std::vector<uint32_t>> allPairs(Gl gl, const Habit& habit) {
  prepare(gl, habit.into);
  std::vector<std::vector<uint32_t>> images;
  for (const GLenum first : kModes)
    for (const GLenum second : kModes) images.push_back(pair(gl, habit, first, second));
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  return images;
}

void expectSamePairs(const Habit& habit) {
  const auto expected = [&] {
    const auto real = OsmesaContext::create({kSize, kSize});
    return allPairs(real->real(), habit);
  }();
  for (const Settings& settings : {TracedContext::tracing(), Settings{}}) {
    TracedContext ours({kSize, kSize}, settings);
    const auto got = allPairs(ours.gl(), habit);
    size_t at = 0;
    for (const GLenum first : kModes)
      for (const GLenum second : kModes) {
        size_t differ = 0;
        for (size_t i = 0; i < got[at].size(); ++i) differ += got[at][i] != expected[at][i];
        // Traced triangles may differ at their edges; a primitive that is lost differs by its whole width.
        EXPECT_LE(differ, 8u) << "mode " << first << ", then " << second;
        ++at;
      }
  }
}

TEST(OwnCalls, PairsOfBegin) {
  for (const Into into : {Into::window, Into::windowByProgram, Into::renderbuffers, Into::texture}) {
    SCOPED_TRACE(static_cast<int>(into));
    expectSamePairs({into, Sent::begin, Sent::begin});
  }
}

TEST(OwnCalls, PairsOfBeginWithCurrentColors) {
  for (const Into into : {Into::windowByProgram, Into::renderbuffers}) {
    expectSamePairs({into, Sent::begin, Sent::begin, true});
    expectSamePairs({into, Sent::begin, Sent::begin, false, true});
  }
}

TEST(OwnCalls, ArraysAndBeginInTurn) {
  for (const Into into : {Into::windowByProgram, Into::renderbuffers}) {
    expectSamePairs({into, Sent::arrays, Sent::begin});
    expectSamePairs({into, Sent::begin, Sent::arrays});
  }
}

/// Errors that the real OpenGL's glBegin raises, while line strips are drawn around it.
std::vector<GLenum> errorsOf(Gl gl, std::vector<uint32_t>& pixels) {
  std::vector<GLenum> errors;
  prepare(gl, Into::renderbuffers);
  GLint complete = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &complete);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), gl.Color3f(0, 0, 0);
  primitive(gl, GL_LINE_STRIP, Sent::begin, -0.8f);
  GLuint incomplete = 0;
  gl.GenFramebuffers(1, &incomplete), gl.BindFramebuffer(GL_FRAMEBUFFER, incomplete);
  for (const GLenum mode : {GLenum{GL_LINE_STRIP}, GLenum{GL_POINTS}, GLenum{GL_QUADS}}) {
    gl.Begin(mode), gl.Vertex2f(0, 0), gl.End();
    for (int i = 0; i < 3; ++i) errors.push_back(gl.GetError());
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(complete));
  primitive(gl, GL_LINE_LOOP, Sent::begin, 0.2f);
  errors.push_back(gl.GetError());
  pixels.resize(kSize * kSize);
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return errors;
}

TEST(OwnCalls, BeginInAnIncompleteFramebufferRaisesTheSameErrors) {
  std::vector<uint32_t> expectedPixels, gotPixels;
  const auto expected = [&] {
    const auto real = OsmesaContext::create({kSize, kSize});
    return errorsOf(real->real(), expectedPixels);
  }();
  TracedContext ours({kSize, kSize}, TracedContext::tracing());
  EXPECT_EQ(errorsOf(ours.gl(), gotPixels), expected);
  EXPECT_EQ(gotPixels, expectedPixels);
}

/// A mapped array buffer refuses draws from arrays only.
std::vector<uint32_t> besideAMappedBuffer(Gl gl) {
  prepare(gl, Into::renderbuffers);
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
  gl.EnableClientState(GL_VERTEX_ARRAY), gl.VertexPointer(2, GL_FLOAT, 0, nullptr);
  EXPECT_TRUE(gl.MapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE));
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), gl.Color3f(0, 0, 0);
  primitive(gl, GL_LINE_LOOP, Sent::begin, -0.8f);
  primitive(gl, GL_QUADS, Sent::begin, 0.2f);
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  gl.UnmapBuffer(GL_ARRAY_BUFFER), gl.BindBuffer(GL_ARRAY_BUFFER, 0), gl.DisableClientState(GL_VERTEX_ARRAY);
  std::vector<uint32_t> pixels(kSize * kSize);
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

TEST(OwnCalls, BeginBesideAMappedBuffer) {
  const auto expected = [&] {
    const auto real = OsmesaContext::create({kSize, kSize});
    return besideAMappedBuffer(real->real());
  }();
  Settings rasterising;
  TracedContext ours({kSize, kSize}, rasterising);
  EXPECT_EQ(besideAMappedBuffer(ours.gl()), expected);
}

}  // namespace
}  // namespace gluray::test::own_calls
