// glBegin that succeeds, and then fails because of a command in between: errors and images are those of the
// real OpenGL, which GLuRay asks once only while nothing changes.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/program_stage.h"
#include "tests/support/traced_context.h"

#include <GL/glext.h>
#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace gluray::test::begin_fails {
namespace {

constexpr int kSize = 32;

struct Objects {
  GLuint framebuffer = 0, incomplete = 0, renderbuffer = 0, list = 0;
  GLuint good = 0, bad = 0;  // programs; bad: two kinds of samplers on one texture unit
  GLint unit = -1;           // of the good program's second sampler
};

using Change = std::function<void(Gl, const Objects&)>;

GLuint makeTwoSamplers(Gl gl, GLint secondUnit) {
  const GLuint program =
      makeProgram(gl, "#version 120\nvoid main() { gl_Position = gl_Vertex; }",
                  "#version 120\nuniform sampler2D plane; uniform sampler3D volume;\n"
                  "void main() { gl_FragColor = vec4(0.2, 0.4, 0.6, 1.0) + texture2D(plane, "
                  "vec2(0.0)) + texture3D(volume, vec3(0.0)); }");
  gl.UseProgram(program), gl.Uniform1i(gl.GetUniformLocation(program, "volume"), secondUnit);
  gl.UseProgram(0);
  return program;
}

Objects prepare(Gl gl) {
  Objects objects;
  bindNewFramebuffer(gl, {kSize, kSize}, GL_RGBA8, GL_DEPTH24_STENCIL8);
  GLint name = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name), objects.framebuffer = static_cast<GLuint>(name);
  gl.GetFramebufferAttachmentParameteriv(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                                         GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &name);
  objects.renderbuffer = static_cast<GLuint>(name);
  gl.GenFramebuffers(1, &objects.incomplete);
  objects.good = makeTwoSamplers(gl, 1), objects.bad = makeTwoSamplers(gl, 0);
  objects.unit = gl.GetUniformLocation(objects.good, "volume");
  objects.list = gl.GenLists(1);
  gl.Viewport(0, 0, kSize, kSize), gl.Enable(GL_DEPTH_TEST), gl.ClearColor(1, 1, 0.9f, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT), gl.Color3f(0, 0, 0);
  gl.UseProgram(objects.good);
  return objects;
}

void line(Gl gl, float x) { gl.Begin(GL_LINES), gl.Vertex2f(x, -0.5f), gl.Vertex2f(x, 0.5f), gl.End(); }

struct Seen {
  std::vector<GLenum> errors;
  std::vector<uint32_t> pixels;
  bool operator==(const Seen&) const = default;
};

Seen drawAround(Gl gl, const Change& change, const Change& back) {
  Seen seen;
  const Objects objects = prepare(gl);
  const auto note = [&] {
    for (int i = 0; i < 3; ++i) seen.errors.push_back(gl.GetError());
  };
  for (int round = 0; round < 2; ++round) {
    line(gl, -0.6f), line(gl, -0.3f), note();
    change(gl, objects);
    line(gl, 0.1f), note();
    back(gl, objects);
    line(gl, 0.6f), note();
  }
  seen.pixels.resize(kSize * kSize);
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, seen.pixels.data());
  return seen;
}

void expectSame(const Change& change, const Change& back) {
  const Seen expected = drawAround(OsmesaContext::create({kSize, kSize})->real(), change, back);
  EXPECT_NE(std::count(expected.errors.begin(), expected.errors.end(), static_cast<GLenum>(GL_NO_ERROR)),
            static_cast<std::ptrdiff_t>(expected.errors.size()))
      << "nothing failed";
  for (const Settings& settings : {TracedContext::tracing(), Settings{}}) {
    TracedContext ours({kSize, kSize}, settings);
    const Seen got = drawAround(ours.gl(), change, back);
    EXPECT_EQ(got.errors, expected.errors);
    EXPECT_EQ(got.pixels, expected.pixels);
  }
}

void useGood(Gl gl, const Objects& o) { gl.UseProgram(o.good); }

TEST(BeginFails, AnotherProgram) {
  expectSame([](Gl gl, const Objects& o) { gl.UseProgram(o.bad); }, useGood);
}

TEST(BeginFails, AnotherSampler) {
  expectSame([](Gl gl, const Objects& o) { gl.Uniform1i(o.unit, 0); },
             [](Gl gl, const Objects& o) { gl.Uniform1i(o.unit, 1); });
}

TEST(BeginFails, AProgramInAList) {
  expectSame(
      [](Gl gl, const Objects& o) {
        gl.NewList(o.list, GL_COMPILE), gl.UseProgram(o.bad), gl.EndList();
        line(gl, -0.2f), gl.CallList(o.list);
      },
      useGood);
}

TEST(BeginFails, BetweenPrimitivesOfAList) {
  for (const GLenum how : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
    expectSame(
        [how](Gl gl, const Objects& o) {
          gl.NewList(o.list, how);
          line(gl, -0.2f), gl.UseProgram(o.bad), line(gl, 0.f);
          gl.EndList();
          if (how == GL_COMPILE) gl.CallList(o.list);
        },
        useGood);
}

TEST(BeginFails, AnIncompleteFramebuffer) {
  expectSame([](Gl gl, const Objects& o) { gl.BindFramebuffer(GL_FRAMEBUFFER, o.incomplete); },
             [](Gl gl, const Objects& o) { gl.BindFramebuffer(GL_FRAMEBUFFER, o.framebuffer); });
}

TEST(BeginFails, AnAttachmentOfAnotherSize) {
  const auto store = [](Gl gl, const Objects& o, GLsizei size) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, o.renderbuffer);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, size, size);
  };
  expectSame([&](Gl gl, const Objects& o) { store(gl, o, 0); },
             [&](Gl gl, const Objects& o) { store(gl, o, kSize), gl.Clear(GL_COLOR_BUFFER_BIT); });
}

}  // namespace
}  // namespace gluray::test::begin_fails
