// Several draws by shader programs: offsets into buffers, cameras, uniforms of every kind,
// and programs and buffers that change between draws.
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Normals = Surface::Normals;
using Lights = Surface::Lights;

View placed(const glm::dvec3& where, double scale, double degrees = 20, bool parallel = false) {
  View view = parallel ? parallelView(degrees) : perspectiveView(degrees);
  view.eyeFromObject = glm::scale(glm::translate(view.eyeFromObject, where), glm::dvec3(scale));
  return view;
}

TEST(ProgramDraws, BlocksOfOneBufferByOffsetsAndTriangleNumbers) {
  expectBoth(
      "blocks",
      [](Gl gl) {
        const Surface surface{.color = Color::cell, .normals = Normals::cell};
        const ProgramMesh mesh = ball(18);
        const GLuint program = makeProgram(gl, surface);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl), gl.UseProgram(program);
        cellColors(gl, mesh, 0, 7), cellNormals(gl, mesh, 1, 7);
        setInteger(gl, program, "textureC", 0), setInteger(gl, program, "textureN", 1);
        setAll(gl, program, perspectiveView(), surface);
        gl.BindVertexArray(up.array);
        const GLsizei third = mesh.count() / 9 * 3;
        for (GLsizei i = 0; i < 3; ++i) {
          setView(gl, program, placed({1.1 * (i - 1), 0, 0.2 * i}, 0.5));
          setInteger(gl, program, "PrimitiveIDOffset", 7 + i * third / 3);
          gl.DrawRangeElements(GL_TRIANGLES, 0, 1000, third, GL_UNSIGNED_INT,
                               reinterpret_cast<const void*>(static_cast<size_t>(i * third) * 4));
        }
      },
      3);
}

TEST(ProgramDraws, TriangleNumbersBeyondTheBufferAreLeftToTheRealOne) {
  const Outcome o = expectSame(
      "beyond",
      [](Gl gl) {
        const Surface surface{.color = Color::cell};
        const ProgramMesh mesh = sheet(4);
        const GLuint program = makeProgram(gl, surface);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl), cellColors(gl, mesh, 0);
        gl.UseProgram(program), setInteger(gl, program, "PrimitiveIDOffset", 1);
        drawSurface(gl, program, up, mesh, perspectiveView(), surface);
      },
      0);
  EXPECT_EQ(o.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::arrayState)], 1u);
}

/// Triangles behind each other by strips, fans, indices of 8 and 16 bits, and without indices.
TEST(ProgramDraws, EveryKindOfTrianglesAndIndices) {
  expectBoth(
      "kinds",
      [](Gl gl) {
        const Surface surface{.color = Color::vertex};
        const GLuint program = makeProgram(gl, surface);
        ProgramMesh mesh = sheet(3);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl), gl.UseProgram(program);
        setAll(gl, program, perspectiveView(), surface);
        const GLubyte bytes[] = {0, 1, 4, 5, 8, 9, 12, 13};
        const GLushort shorts[] = {0, 1, 5, 9, 8, 4};
        GLuint buffers[2];
        gl.GenBuffers(2, buffers);
        gl.BindVertexArray(up.array);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof bytes, bytes, GL_STATIC_DRAW);
        setView(gl, program, placed({-1.1, 0, 0}, 0.6));
        gl.DrawElements(GL_TRIANGLE_STRIP, 8, GL_UNSIGNED_BYTE, nullptr);
        gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof shorts, shorts, GL_STATIC_DRAW);
        setView(gl, program, placed({0, 0.3, 0}, 0.6));
        gl.DrawElements(GL_TRIANGLE_FAN, 6, GL_UNSIGNED_SHORT, nullptr);
        setView(gl, program, placed({1.1, 0, 0}, 0.6));
        gl.DrawArrays(GL_TRIANGLES, 1, 12);
        setView(gl, program, placed({0.2, -1.1, 0}, 0.6));
        gl.DrawElementsBaseVertex(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr, 4);
      },
      4);
}

TEST(ProgramDraws, SeveralCamerasAndViewportsInAFrame) {
  expectBoth(
      "cameras",
      [](Gl gl) {
        const Surface surface{.lightCount = 2};
        const ProgramMesh mesh = ball(20);
        const GLuint program = makeProgram(gl, surface);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl);
        for (int i = 0; i < 3; ++i)
          drawSurface(gl, program, up, mesh, placed({0.9 * i - 0.9, 0, 0.3 * i}, 0.4), surface);
        drawSurface(gl, program, up, mesh, placed({0, 0.9, 0}, 0.3, 40, true), surface);
        gl.Viewport(10, 5, 60, 45);
        drawSurface(gl, program, up, mesh, placed({0, -0.9, 0}, 0.5, 70), surface);
        gl.Viewport(120, 5, 80, 45);
        drawSurface(gl, program, up, mesh, placed({0, -0.9, 0}, 0.5, 70, true), surface);
      },
      6);
}

TEST(ProgramDraws, MatricesThatTheProgramHasNoPlaceFor) {
  // The headlight's program has no MCVCMatrix: draws are placed by MCDCMatrix.
  const Outcome o = expectSame(
      "placeless",
      [](Gl gl) {
        const Surface surface{.lights = Lights::headlight};
        const ProgramMesh mesh = ball(20);
        const GLuint program = makeProgram(gl, surface);
        EXPECT_EQ(gl.GetUniformLocation(program, "MCVCMatrix"), -1);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl);
        for (int i = 0; i < 4; ++i)
          drawSurface(gl, program, up, mesh, placed({0.7 * i - 1, 0.3 * (i % 2), 0.4 * i}, 0.5, 11 * i),
                      surface);
      },
      4);
  EXPECT_EQ(o.statistics.flushes, 1u) << "one camera is one batch";
}

TEST(ProgramDraws, RoundingOfMatricesSplitsNoBatch) {
  // The projection is known only as a product of matrices in single precision, a little different for each
  // draw.
  for (const bool parallel : {false, true}) {
    const Outcome o = expectSame(
        parallel ? "rounding_parallel" : "rounding",
        [&](Gl gl) {
          const Surface surface{.color = Color::vertex};
          const ProgramMesh mesh = ball(6);
          const GLuint program = makeProgram(gl, surface);
          const Upload up = upload(gl, mesh, program);
          beginFrame(gl);
          for (int i = 0; i < 60; ++i) {
            const glm::dvec3 where(0.33 * (i % 10) - 1.5, 0.41 * (i / 10) - 1, 0.017 * i);
            drawSurface(gl, program, up, mesh, placed(where, 0.05 + 0.002 * i, 7 * i, parallel), surface);
          }
        },
        60);
    EXPECT_EQ(o.statistics.flushes, 1u);
  }
}

TEST(ProgramDraws, FarFromTheOrigin) {
  // Rounding moves points of either image by some 1e-7 of a million: silhouettes differ by a pixel.
  constexpr double kFar = 1e6;
  expectBoth("far",
             [](Gl gl) {
               const Surface surface{.lightCount = 2};
               ProgramMesh mesh = ball(20);
               for (glm::vec3& p : mesh.positions) p = p * 1000.0f + glm::vec3(kFar, -kFar, kFar);
               const GLuint program = makeProgram(gl, surface);
               const Upload up = upload(gl, mesh, program);
               View view = perspectiveView(30);
               view.eyeFromObject = glm::scale(view.eyeFromObject, glm::dvec3(0.001));
               view.eyeFromObject = glm::translate(view.eyeFromObject, {-kFar, kFar, -kFar});
               beginFrame(gl);
               drawSurface(gl, program, up, mesh, view, surface);
             },
             1, {}, {3, 0.02, 3e-4f, "single precision at 1e6 with details of 1e3"});
}

TEST(ProgramDraws, HugeMatrices) {
  expectBoth(
      "huge",
      [](Gl gl) {
        const Surface surface{};
        const ProgramMesh mesh = ball(20);
        const GLuint program = makeProgram(gl, surface);
        const Upload up = upload(gl, mesh, program);
        const auto far = [](double x) {
          const glm::dmat4 away = glm::translate(glm::dmat4(1), {x, 0.2e6, -4e6});
          return View{glm::scale(away, glm::dvec3(0.6e6)), glm::perspective(0.7, 4.0 / 3, 1e5, 1e7)};
        };
        beginFrame(gl);
        drawSurface(gl, program, up, mesh, far(-0.7e6), surface);
        drawSurface(gl, program, up, mesh, far(0.7e6), surface);
      },
      2);
}

TEST(ProgramDraws, UniformsOfAnotherProgramByProgramUniform) {
  expectBoth(
      "program_uniform",
      [](Gl gl) {
        const Surface surface{.version = "#version 410\n"};
        const ProgramMesh mesh = ball(16);
        const GLuint program = makeProgram(gl, surface);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl);
        drawSurface(gl, program, up, mesh, placed({-0.8, 0, 0}, 0.6), surface);
        const View view = placed({0.8, 0, 0}, 0.6);
        const glm::mat4 clip(view.clipFromEye * view.eyeFromObject);
        gl.ProgramUniformMatrix4fv(program, gl.GetUniformLocation(program, "MCDCMatrix"), 1, GL_FALSE,
                                   glm::value_ptr(clip));
        gl.ProgramUniform3f(program, gl.GetUniformLocation(program, "diffuseColorUniform"), 1, 0.2f, 0);
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
      },
      2, coreWish(4, 5));
}

TEST(ProgramDraws, BufferContentsChangeBetweenDrawAndFlush) {
  expectBoth(
      "respecified",
      [](Gl gl) {
        const Surface surface{.color = Color::vertex};
        ProgramMesh mesh = ball(16);
        const GLuint program = makeProgram(gl, surface);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl);
        drawSurface(gl, program, up, mesh, placed({-0.8, 0, 0}, 0.6), surface);
        for (glm::vec3& p : mesh.positions) p.x *= 0.5f;
        gl.BindBuffer(GL_ARRAY_BUFFER, up.positions);
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(12 * mesh.positions.size()),
                      mesh.positions.data(), GL_STATIC_DRAW);
        drawSurface(gl, program, up, mesh, placed({0.3, 0, 0}, 0.6), surface);
        for (uint32_t& c : mesh.colors) c = c & 0xff00ff00u;
        gl.BindBuffer(GL_ARRAY_BUFFER, up.colors);
        gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(4 * mesh.colors.size()),
                         mesh.colors.data());
        drawSurface(gl, program, up, mesh, placed({1.2, 0, 0}, 0.6), surface);
        gl.DeleteBuffers(1, &up.positions), gl.DeleteVertexArrays(1, &up.array);
      },
      3);
}

TEST(ProgramDraws, TexturesChangeBetweenDrawAndFlush) {
  expectBoth(
      "retextured",
      [](Gl gl) {
        const Surface surface{.color = Color::cell, .actorTexture = true};
        const ProgramMesh mesh = ball(10);
        const GLuint program = makeProgram(gl, surface);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl), gl.UseProgram(program);
        cellColors(gl, mesh, 1), setInteger(gl, program, "textureC", 1);
        chequers(gl, 0), setInteger(gl, program, "actortexture", 0);
        drawSurface(gl, program, up, mesh, placed({-0.8, 0, 0}, 0.6), surface);
        gl.ActiveTexture(GL_TEXTURE0);
        const std::vector<uint8_t> grey(8 * 8 * 4, 128);
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, grey.data());
        const std::vector<uint32_t> red(mesh.triangles(), 0xff2020ffu);
        gl.BufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(4 * red.size()), red.data());
        drawSurface(gl, program, up, mesh, placed({0.8, 0, 0}, 0.6), surface);
        chequers(gl, 0);  // another texture on the unit
        drawSurface(gl, program, up, mesh, placed({0, 0.9, 0}, 0.3), surface);
      },
      3);
}

TEST(ProgramDraws, IndexBufferShorterThanTheDraw) {
  // Data beyond the end is undefined; nothing may be read there, and later draws must be right.
  TracedContext ours(coreWish(), TracedContext::tracing());
  Gl gl = ours.gl();
  const Surface surface{};
  const ProgramMesh mesh = ball(10);
  const GLuint program = makeProgram(gl, surface);
  const Upload up = upload(gl, mesh, program);
  beginFrame(gl);
  drawSurface(gl, program, up, mesh, perspectiveView(), surface);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, 30, mesh.indices.data(), GL_STATIC_DRAW);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  gl.DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, reinterpret_cast<const void*>(size_t{1} << 20));
  gl.Finish();
  EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
  EXPECT_FALSE(ours.context().info().off);
}

}  // namespace
}  // namespace gluray::test
