// Volumes of a ray caster of the tests in framebuffer objects.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/volumes/volume_stage.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

/// Draws the box into a framebuffer object and copies it to the window.
DrawProgram drawingInto(GLenum color, GLsizei samples) {
  return [=](Gl gl) {
    const CastBox box(gl, makeCaster(gl));
    makeVoxels(gl, {});
    bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, color, GL_DEPTH_COMPONENT24, samples);
    beginFrame(gl);
    box.begin(gl, perspectiveView(30));
    box.draw(gl);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  };
}

TEST(ProgramVolumes, FramebufferObjects) {
  expectSame("volume-into-bytes", drawingInto(GL_RGBA8, 0), 1, {}, kVolumeTolerance, casterFamily());
  expectSame("volume-into-samples", drawingInto(GL_RGBA8, 4), -1, {}, kVolumeTolerance, casterFamily());
  expectSame("volume-into-halves", drawingInto(GL_RGBA16F, 0), 1, {}, kVolumeTolerance, casterFamily());
}

}  // namespace
}  // namespace gluray::test
