// Draws by shader programs into framebuffer objects: formats of depth, samples, incomplete ones.
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;

View placedUpright(const glm::dvec3& where, double scale) {
  View view = perspectiveView(20);
  view.eyeFromObject = glm::scale(glm::translate(view.eyeFromObject, where), glm::dvec3(scale));
  return view;
}

GLuint attachedTexture(Gl gl, GLenum target, GLenum format, GLenum kind, GLenum type) {
  GLuint name = 0;
  gl.GenTextures(1, &name), gl.BindTexture(target, name);
  if (target == GL_TEXTURE_2D_MULTISAMPLE)
    gl.TexImage2DMultisample(target, 4, format, kProgramWidth, kProgramHeight, GL_TRUE);
  else
    gl.TexImage2D(target, 0, static_cast<GLint>(format), kProgramWidth, kProgramHeight, 0, kind, type,
                  nullptr);
  if (target == GL_TEXTURE_2D) gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  return name;
}

/// Draws into a framebuffer object with textures, then copies colour and depth into the window.
void drawInto(Gl gl, GLenum target, GLenum depthFormat,
              const Surface& surface = {.color = Color::vertex, .lightCount = 2}) {
  const bool stencil = depthFormat == GL_DEPTH24_STENCIL8;
  GLuint framebuffers[2] = {};
  gl.GenFramebuffers(2, framebuffers);
  const auto attach = [&](GLuint framebuffer, GLenum kind) {
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, kind,
                            attachedTexture(gl, kind, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE), 0);
    gl.FramebufferTexture2D(
        GL_FRAMEBUFFER, stencil ? GL_DEPTH_STENCIL_ATTACHMENT : GL_DEPTH_ATTACHMENT, kind,
        attachedTexture(gl, kind, depthFormat, stencil ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT,
                        stencil ? GL_UNSIGNED_INT_24_8 : GL_UNSIGNED_INT),
        0);
    EXPECT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  };
  attach(framebuffers[1], GL_TEXTURE_2D);
  attach(framebuffers[0], target);
  const ProgramMesh mesh = surface.color == Color::mapped ? sheet(20) : ball(20);
  const GLuint program = makeProgram(gl, surface);
  const Upload up = upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  if (surface.color == Color::mapped) colorMap(gl, 3), setInteger(gl, program, "colortexture", 3);
  drawSurface(gl, program, up, mesh, placedUpright({-0.4, 0, 0}, 0.8), surface);
  drawSurface(gl, program, up, mesh, placedUpright({0.5, 0, 0.3}, 0.7), surface);
  GLuint from = framebuffers[0];
  if (target == GL_TEXTURE_2D_MULTISAMPLE) {
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffers[0]),
        gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffers[1]);
    gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                       GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    from = framebuffers[1];
  }
  gl.BindFramebuffer(GL_FRAMEBUFFER, from);
}

TEST(ProgramFramebuffers, WithTexturesOf24BitsAndStencil) {
  expectBoth(
      "fbo24", [](Gl gl) { drawInto(gl, GL_TEXTURE_2D, GL_DEPTH24_STENCIL8); }, 2);
}
TEST(ProgramFramebuffers, WithDepthOf32Bits) {
  expectBoth(
      "fbo32", [](Gl gl) { drawInto(gl, GL_TEXTURE_2D, GL_DEPTH_COMPONENT32); }, 2);
}
/// The depth of a resolved pixel may be that of any of its samples.
constexpr scenes::Tolerance kManySamples{2, 0.002, 2e-2f, "silhouettes fall on either side of a sample"};
TEST(ProgramFramebuffers, WithFourSamples) {
  expectBoth(
      "fbo4x", [](Gl gl) { drawInto(gl, GL_TEXTURE_2D_MULTISAMPLE, GL_DEPTH24_STENCIL8); }, 2, {},
      kManySamples);
}
TEST(ProgramFramebuffers, MultisampledSurfacesAreShadedOnceAPixel) {
  const Surface surface{.color = Color::mapped, .lights = Surface::Lights::none};
  expectBoth(
      "fbo4x_mapped", [&](Gl gl) { drawInto(gl, GL_TEXTURE_2D_MULTISAMPLE, GL_DEPTH24_STENCIL8, surface); },
      2, {}, kManySamples);
}

TEST(ProgramFramebuffers, IncompleteFramebufferDrawsNothing) {
  expectBoth(
      "incomplete",
      [](Gl gl) {
        const Surface surface{};
        const ProgramMesh mesh = ball(10);
        const GLuint program = makeProgram(gl, surface);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl);
        GLuint framebuffer = 0;
        gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        drawSurface(gl, program, up, mesh, perspectiveView(), surface);
        EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_INVALID_FRAMEBUFFER_OPERATION));
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        drawSurface(gl, program, up, mesh, perspectiveView(), surface);
      },
      1);
}

}  // namespace
}  // namespace gluray::test
