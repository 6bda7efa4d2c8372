// Units of glPolygonOffset for each depth format: compares the real OpenGL's depths with GLuRay's.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/program_stage.h"
#include "tests/support/traced_context.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

constexpr int kOffsetSize = 16;

/// Depths in the middle of some surfaces, offset by units only, in a framebuffer object of `format`.
std::vector<float> depths(const gl::RealGl& gl, GLenum format) {
  bindNewFramebuffer(gl, {kOffsetSize, kOffsetSize}, GL_RGBA8, format);
  gl.Viewport(0, 0, kOffsetSize, kOffsetSize), gl.Enable(GL_DEPTH_TEST), gl.Enable(GL_POLYGON_OFFSET_FILL);
  std::vector<float> found;
  for (const float units : {0.0f, 3.0f, 60000.0f, -70000.0f})
    for (const float z : {-0.9f, -0.6f, -0.2f, 0.2f, 0.7f}) {
      gl.PolygonOffset(0, units);
      gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      // Slightly tilted: flat surfaces are rasterised.
      gl.Begin(GL_TRIANGLES);
      gl.Vertex3f(-1, -1, z), gl.Vertex3f(3, -1, z + 1e-3f), gl.Vertex3f(-1, 3, z);
      gl.End();
      float depth = 0;
      gl.ReadPixels(kOffsetSize / 2, kOffsetSize / 2, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
      found.push_back(depth);
    }
  return found;
}

TEST(PolygonOffset, UnitsAreThoseOfTheDepthBuffer) {
  for (const GLenum format : {GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT32F}) {
    const auto real = OsmesaContext::create();
    const std::vector<float> expected = depths(real->real(), format);
    const TracedContext traced;
    const std::vector<float> ours = depths(traced.gl(), format);
    EXPECT_GT(traced.context().counts.statistics.drawsTraced, 0u);
    for (size_t i = 0; i < expected.size(); ++i)
      EXPECT_NEAR(ours[i], expected[i], 3e-7f) << "format " << format << ", number " << i;
  }
}

/// Formats of the depth buffer; 0: the window's.
constexpr GLenum kFormats[] = {0, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32, GL_DEPTH_COMPONENT32F};

struct Offset {
  float factor, units;
};
std::string nameOf(const Offset& offset, GLenum format) {
  return std::to_string(offset.factor) + "_" + std::to_string(offset.units) + "_" + std::to_string(format);
}

/// Into the window, or a framebuffer object whose depth has this format.
void into(Gl gl, GLenum format) {
  if (format) bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, GL_RGBA8, format);
}

/// Two sheets, `degrees` apart, the second one moved by the offset of OpenGL.
void drawMoved(Gl gl, const Surface& surface, const Offset& offset, double degrees = 30) {
  const GLuint program = makeProgram(gl, surface);
  const ProgramMesh mesh = sheet(12);
  const Upload up = upload(gl, mesh, program);
  beginFrame(gl);
  drawSurface(gl, program, up, mesh, perspectiveView(20), surface);
  gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(offset.factor, offset.units);
  drawSurface(gl, program, up, mesh, perspectiveView(20 + degrees), surface);
  gl.Disable(GL_POLYGON_OFFSET_FILL);
}

TEST(PolygonOffset, AppliesToShaderPrograms) {
  for (const Offset& offset : {Offset{2, 0}, {-3, 0}, {0, 90000}, {1.5f, -120000}})
    for (const GLenum format : kFormats)
      expectBoth(
          "offset" + nameOf(offset, format), [&](Gl gl) { into(gl, format), drawMoved(gl, {}, offset); }, 2);
}

/// A decal: the same triangles in other colours, in front of the surface or behind it.
TEST(PolygonOffset, DecalsLieBeforeTheirSurface) {
  const Surface surface{.color = Surface::Color::vertex};
  for (const Offset& offset : {Offset{-1, -1}, {-1, 0}, {1, 1}})
    for (const GLenum format : kFormats)
      expectBoth(
          "decal" + nameOf(offset, format),
          [&](Gl gl) { into(gl, format), drawMoved(gl, surface, offset, 0); }, -1);
}

/// A surface of a program of no family beside a traced one, both offset.
TEST(PolygonOffset, AppliesBesideRasterisedSurfaces) {
  for (const GLenum format : kFormats)
    expectBoth(
        "beside" + std::to_string(format),
        [&](Gl gl) {
          into(gl, format);
          const ProgramMesh flat = sheet(12), round = ball(16);
          const GLuint program = makeProgram(gl, Surface{}), unknown = makeUnknownProgram(gl);
          const Upload flatUp = upload(gl, flat, program), roundUp = upload(gl, round, unknown);
          beginFrame(gl);
          gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(2, 50000);
          drawByUnknown(gl, unknown, roundUp, round, perspectiveView(20));
          drawSurface(gl, program, flatUp, flat, perspectiveView(20), {});
          gl.PolygonOffset(-2, -40000);
          drawSurface(gl, program, flatUp, flat, perspectiveView(80), {});
          gl.Disable(GL_POLYGON_OFFSET_FILL);
        },
        2);
}

/// The program's own offset, with a clamp, is restored after GLuRay drew in its place.
TEST(PolygonOffset, KeepsTheClampOfTheProgram) {
  expectBoth(
      "clamp",
      [](Gl gl) {
        drawMoved(gl, {}, {1, 1000});
        gl.PolygonOffsetClamp(3, 4, 0.01f);
        gl.Finish();
        GLfloat clamp = 0;
        gl.GetFloatv(GL_POLYGON_OFFSET_CLAMP, &clamp);
        EXPECT_EQ(clamp, 0.01f);
      },
      2, coreWish(4, 5));
}

/// Three nested balls with differently coloured vertices: where they are steep, along silhouettes, the offset
/// may put hidden surfaces in front of them.
void drawBalls(Gl gl, const Surface& surface, const std::function<void(GLuint)>& set) {
  const GLuint program = makeProgram(gl, surface);
  const ProgramMesh mesh = ball(14);
  const Upload up = upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  if (set) set(program);
  for (const double size : {1.0, 0.96, 0.8}) {
    View view = perspectiveView(20 + 90 * size);
    view.eyeFromObject = glm::scale(view.eyeFromObject, glm::dvec3(size));
    drawSurface(gl, program, up, mesh, view, surface);
  }
}

GLuint bound(Gl gl) {
  GLint name = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
  return static_cast<GLuint>(name);
}

constexpr scenes::Tolerance kFewPixels{2, 0.0004, 1e-5f,
                                       "silhouettes fall on either side of a pixel's centre"};
const Surface kUnlike{.color = Surface::Color::vertex, .lights = Surface::Lights::none};

TEST(PolygonOffset, ByFactorsDecidesWhichSideOfASilhouetteIsSeen) {
  for (const float factor : {0.5f, 3.0f, 12.0f, -1.0f, -3.0f})
    for (const bool cull : {false, true}) {
      const std::string name = "balls" + std::to_string(factor) + (cull ? "_culled" : "");
      expectBoth(
          name,
          [&](Gl gl) {
            gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(factor, 1);
            if (cull) gl.Enable(GL_CULL_FACE);
            drawBalls(gl, kUnlike, {});
            gl.Disable(GL_POLYGON_OFFSET_FILL), gl.Disable(GL_CULL_FACE);
          },
          3, {}, kFewPixels);
    }
}

TEST(PolygonOffset, ByFactorsOfProgramsDecidesTheSame) {
  Surface surface = kUnlike;
  surface.depthOffset = true;
  for (const float factor : {2.0f, 8.0f, -4.0f})
    expectBoth(
        "program_balls" + std::to_string(factor),
        [&](Gl gl) {
          drawBalls(gl, surface, [&](GLuint program) { setFloat(gl, program, "cFactor", factor); });
        },
        3, {}, kFewPixels);
}

/// The depth that a program writes is that of the pixel's centre for all samples.
TEST(PolygonOffset, OfProgramsInMultisampledFramebuffers) {
  // The depth of a resolved pixel may be that of any of its samples.
  constexpr scenes::Tolerance kResolved{2, 0.0004, 2e-2f, "silhouettes fall on either side of a sample"};
  Surface surface = kUnlike;
  surface.depthOffset = true;
  const glm::ivec2 size(kProgramWidth, kProgramHeight);
  for (const float factor : {0.0f, 0.5f, 4.0f, -1.0f})
    expectBoth(
        "samples_balls" + std::to_string(factor),
        [&](Gl gl) {
          bindNewFramebuffer(gl, size, GL_RGBA8, GL_DEPTH_COMPONENT24, 4);
          const GLuint samples = bound(gl);
          drawBalls(gl, surface, [&](GLuint program) {
            setFloat(gl, program, "cFactor", factor), setFloat(gl, program, "cOffset", 5);
          });
          bindNewFramebuffer(gl, size, GL_RGBA8, GL_DEPTH_COMPONENT24);
          const GLuint resolved = bound(gl);
          gl.BindFramebuffer(GL_READ_FRAMEBUFFER, samples);
          gl.BlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y,
                             GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
          gl.BindFramebuffer(GL_FRAMEBUFFER, resolved);
        },
        3, {}, kResolved);
}

/// Its shader writes depth: OpenGL decides whether the offset is added.
TEST(PolygonOffset, OfProgramsThatWriteDepthIsLeftToTheRealOne) {
  const Surface surface{.depthOffset = true};
  expectSame(
      "offset_twice",
      [&](Gl gl) {
        drawMoved(gl, surface, {2, 90000});
      },
      1);
}

}  // namespace
}  // namespace gluray::test
