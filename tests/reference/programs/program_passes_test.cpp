// Surfaces that shader programs draw in several passes; the programs of later passes have no family.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

/// A ball in front of a wall, then the ball again; `looked`: the framebuffer is read in between.
void drawFrames(Gl gl, int frames, bool looked, GLenum func) {
  const ProgramMesh round = ball(24), flat = sheet(8);
  const GLuint program = makeProgram(gl, Surface{}), again = makeUnknownProgram(gl);
  const Upload ballUp = upload(gl, round, program), flatUp = upload(gl, flat, program),
               againUp = upload(gl, round, again);
  const View view = perspectiveView(20);
  for (int i = 0; i < frames; ++i) {
    beginFrame(gl);
    gl.DepthFunc(GL_LEQUAL);
    drawSurface(gl, program, flatUp, flat, view, {});
    drawSurface(gl, program, ballUp, round, view, {});
    GLubyte pixel[4];
    if (looked) gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
    gl.DepthFunc(func);
    drawByUnknown(gl, again, againUp, round, view);
    gl.DepthFunc(GL_LEQUAL);
  }
}

TEST(ProgramPasses, FindTheDepthOfTheFirst) {
  for (const GLenum func : {GL_LEQUAL, GL_EQUAL, GL_LESS})
    for (const bool looked : {false, true})
      for (const int frames : {1, 3})
        expectSame(
            "passes" + std::to_string(func) + (looked ? "looked" : "") + std::to_string(frames),
            [&](Gl gl) { drawFrames(gl, frames, looked, func); }, -1);
}

/// Both passes could be traced, in separate batches.
TEST(ProgramPasses, OfOneProgramInTwoBatches) {
  for (const GLenum func : {GL_LEQUAL, GL_LESS})
    for (const int frames : {1, 3}) {
      const Outcome o = expectSame(
          "passes_batches" + std::to_string(func) + std::to_string(frames),
          [&](Gl gl) {
            const ProgramMesh round = ball(24);
            const GLuint program = makeProgram(gl, Surface{});
            const Upload up = upload(gl, round, program);
            for (int i = 0; i < frames; ++i) {
              beginFrame(gl);
              gl.DepthFunc(GL_LEQUAL);
              drawSurface(gl, program, up, round, perspectiveView(20), Surface{});
              GLubyte pixel[4];
              gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel);
              gl.DepthFunc(func);
              setVec3(gl, program, "diffuseColorUniform", {0.1f, 0.9f, 0.2f});
              gl.DrawElements(GL_TRIANGLES, round.count(), GL_UNSIGNED_INT, nullptr);
            }
          },
          -1);
      EXPECT_GT(o.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::passes)], 0u);
    }
}

/// The numbers of the later pass, or of the first one, are in a buffer object.
TEST(ProgramPasses, OfIndirectDraws) {
  for (const bool first : {false, true})
    for (const bool several : {false, true}) {
      const Outcome o = expectSame(
          std::string("passes_indirect") + (first ? "_first" : "") + (several ? "_several" : ""),
          [&](Gl gl) {
            const ProgramMesh round = ball(24);
            const GLuint program = makeProgram(gl, Surface{}), other = makeUnknownProgram(gl);
            const Upload up = upload(gl, round, program), otherUp = upload(gl, round, other);
            const GLuint command[] = {static_cast<GLuint>(round.count()), 1, 0, 0, 0};
            GLuint buffer = 0;
            gl.GenBuffers(1, &buffer);
            gl.BindBuffer(GL_DRAW_INDIRECT_BUFFER, buffer);
            gl.BufferData(GL_DRAW_INDIRECT_BUFFER, sizeof command, command, GL_STATIC_DRAW);
            const View view = perspectiveView(20);
            const auto indirect = [&] {
              gl.UseProgram(other);
              setMat4(gl, other, "MCDCMatrix", glm::mat4(view.clipFromEye * view.eyeFromObject));
              gl.BindVertexArray(otherUp.array);
              if (several)
                gl.MultiDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr, 1, 0);
              else
                gl.DrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
            };
            for (int i = 0; i < 3; ++i) {
              beginFrame(gl);
              gl.DepthFunc(GL_LEQUAL);
              if (first) indirect();
              drawSurface(gl, program, up, round, view, {});
              gl.DepthFunc(GL_EQUAL);
              if (!first) indirect();
              gl.DepthFunc(GL_LEQUAL);
            }
          },
          first ? 0 : -1, coreWish(4, 3));
      EXPECT_GT(o.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::passes)], 0u);
    }
}

/// The depth of a resolved pixel may be that of any of its samples: compares only colours.
TEST(ProgramPasses, OfSeveralSamples) {
  for (const bool looked : {false, true})
    expectSame(
        looked ? "passes_samples_looked" : "passes_samples",
        [&](Gl gl) {
          bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, GL_RGBA8, GL_DEPTH_COMPONENT24, 4);
          drawFrames(gl, 1, looked, GL_LEQUAL);
          gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
          gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                             GL_COLOR_BUFFER_BIT, GL_NEAREST);
          gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        },
        -1);
}

/// Like shadow maps for many lights, before the first swap.
TEST(ProgramPasses, FindItAfterOtherFramebuffersWereClearedAndDrawnTo) {
  expectSame(
      "passes_shadow_maps",
      [&](Gl gl) {
        const ProgramMesh round = ball(24);
        const GLuint program = makeProgram(gl, Surface{}), again = makeUnknownProgram(gl);
        const Upload up = upload(gl, round, program), againUp = upload(gl, round, again);
        const View view = perspectiveView(20);
        beginFrame(gl);
        drawSurface(gl, program, up, round, view, {});
        bindNewFramebuffer(gl, {64, 64}, GL_RGBA8, GL_DEPTH_COMPONENT24);
        gl.Viewport(0, 0, 64, 64);
        for (int light = 0; light < 8; ++light) {
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
          drawSurface(gl, program, up, round, perspectiveView(20.0f + static_cast<float>(light)), {});
        }
        gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
        gl.Viewport(0, 0, kProgramWidth, kProgramHeight);
        gl.DepthFunc(GL_LEQUAL);
        drawByUnknown(gl, again, againUp, round, view);
      },
      -1);
}

/// The pass of a program without family comes first: a depth pre-pass.
TEST(ProgramPasses, TheRasterisedPassComesFirst) {
  for (const int frames : {1, 3})
    for (const bool colors : {false, true})
      expectSame(
          "passes_first" + std::to_string(frames) + std::to_string(colors),
          [&](Gl gl) {
            const ProgramMesh round = ball(24);
            const GLuint program = makeProgram(gl, Surface{}), before = makeUnknownProgram(gl);
            const Upload up = upload(gl, round, program), beforeUp = upload(gl, round, before);
            for (int i = 0; i < frames; ++i) {
              beginFrame(gl);
              gl.ColorMask(colors, colors, colors, colors);
              drawByUnknown(gl, before, beforeUp, round, perspectiveView(20));
              gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
              drawSurface(gl, program, up, round, perspectiveView(20), {});
            }
          },
          0);
}

/// Until the program was linked, no draw was compared with others.
TEST(ProgramPasses, TheProgramIsLinkedAfterTheRasterisedPass) {
  const Outcome o = expectSame(
      "passes_linked_between",
      [&](Gl gl) {
        const ProgramMesh round = ball(24);
        const GLuint before = makeUnknownProgram(gl);
        const Upload beforeUp = upload(gl, round, before);
        GLuint program = 0;
        Upload up;
        for (int i = 0; i < 5; ++i) {
          beginFrame(gl);
          drawByUnknown(gl, before, beforeUp, round, perspectiveView(20));
          if (i == 2) program = makeProgram(gl, Surface{}), up = upload(gl, round, program);
          if (program != 0) drawSurface(gl, program, up, round, perspectiveView(20), {});
        }
      },
      0);
  EXPECT_EQ(o.statistics.drawsRasterised, 8u);
  EXPECT_GE(o.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::passes)], 3u);
}

/// An image of one frame is traced though other surfaces and lines were drawn before its program was linked.
TEST(ProgramPasses, TheProgramIsLinkedAfterOtherSurfaces) {
  for (const bool several : {false, true}) {
    const Outcome o = expectSame(
        several ? "passes_linked_after_others_together" : "passes_linked_after_others",
        [&](Gl gl) {
          const ProgramMesh round = ball(24), flat = sheet(8);
          const GLuint before = makeUnknownProgram(gl);
          const Upload beforeUp = upload(gl, flat, before);
          beginFrame(gl);
          drawByUnknown(gl, before, beforeUp, flat, perspectiveView(20));
          gl.DrawElements(GL_LINES, flat.count(), GL_UNSIGNED_INT, nullptr);
          const GLsizei counts[] = {flat.count(), 6};
          const void* const none[] = {nullptr, nullptr};
          if (several) gl.MultiDrawElements(GL_TRIANGLES, counts, GL_UNSIGNED_INT, none, 2);
          const GLuint program = makeProgram(gl, Surface{});
          drawSurface(gl, program, upload(gl, round, program), round, perspectiveView(20), {});
        },
        -1);
    EXPECT_EQ(o.statistics.drawsTraced, 1u);
  }
}

TEST(ProgramPasses, AnotherSurfaceStaysTraced) {
  const Outcome o = expectSame(
      "passes_other", [&](Gl gl) { drawFrames(gl, 4, false, GL_LEQUAL); }, -1);
  EXPECT_GE(o.statistics.drawsTraced, 3u);
  EXPECT_GT(o.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::passes)], 0u);
}

}  // namespace
}  // namespace gluray::test
