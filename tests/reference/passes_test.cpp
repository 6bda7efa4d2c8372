// Surfaces drawn in several passes over many frames: rasterised while the passes come, traced again
// afterwards.
#include "scenes/stage.h"
#include "tests/reference/traced_context.h"
#include "tests/support/gl_state.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace gluray::test {
namespace {

using namespace scenes;

constexpr int kWidth = 160, kHeight = 120;

/// A sphere, and over it a tint where `tinted`; a label in between where `labelled`.
void drawFrame(Gl gl, bool tinted, bool labelled) {
  begin(gl, kWidth, kHeight);
  camera(gl, kWidth, kHeight);
  keyLight(gl);
  paint(gl, 0.3f, 0.5f, 0.7f);
  const Model m = sphere(24, 36);
  send(gl, m);
  if (labelled) {
    constexpr GLubyte kDot[] = {0xff};
    gl.RasterPos3f(1, 1, 1);
    gl.Bitmap(8, 1, 0, 0, 0, 0, kDot);
  }
  if (!tinted) return;
  gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), gl.DepthFunc(GL_EQUAL);
  paint(gl, 0.5f, 0.2f, 0);
  send(gl, m);
  gl.Disable(GL_BLEND), gl.DepthFunc(GL_LESS);
}

constexpr int kTinted = 6, kFrames = kTinted + 110;

std::vector<Picture> expectedFrames(bool labelled) {
  const auto real = OsmesaContext::create({kWidth, kHeight});
  std::vector<Picture> pictures;
  for (int frame = 0; frame < kFrames; ++frame) {
    drawFrame(real->real(), frame < kTinted, labelled);
    pictures.push_back(readPicture(real->real(), kWidth, kHeight));
  }
  return pictures;
}

void expectFrames(bool labelled) {
  const std::vector<Picture> expected = expectedFrames(labelled);
  TracedContext ours({kWidth, kHeight});
  const gl::Statistics& s = ours.context().statistics;
  for (int frame = 0; frame < kFrames; ++frame) {
    const uint64_t before = s.drawsTraced;
    drawFrame(ours.gl(), frame < kTinted, labelled);
    ours.gl().Finish();
    const uint64_t traced = s.drawsTraced - before;
    const Comparison c = compare(expected[static_cast<size_t>(frame)], ours.read(), {});
    EXPECT_TRUE(c.accepted) << "frame " << frame << ": " << c.text;
    if (frame > 0 && frame < kTinted) { EXPECT_EQ(traced, 0u) << "frame " << frame; }
    if (frame > kTinted + 105) { EXPECT_EQ(traced, 1u) << "frame " << frame; }
  }
}

TEST(Passes, AreRasterisedWhileTheyCome) { expectFrames(false); }

// The first pass was traced already when the second comes: its depth is drawn again.
TEST(Passes, AreRightFromTheFirstFrameOnBehindALabel) { expectFrames(true); }

TEST(Passes, DepthThatIsDrawnAgainLeavesTheStateAlone) {
  const auto draw = [](Gl gl) {
    gl.PixelTransferf(GL_DEPTH_SCALE, 0.5f), gl.PixelTransferf(GL_DEPTH_BIAS, 0.1f);
    drawFrame(gl, true, true);
    EXPECT_EQ(gl.GetError(), static_cast<GLenum>(GL_NO_ERROR));
    GlState state = queryState(gl);
    gl.PixelTransferf(GL_DEPTH_SCALE, 1), gl.PixelTransferf(GL_DEPTH_BIAS, 0);
    return std::make_pair(std::move(state), readPicture(gl, kWidth, kHeight));
  };
  const auto real = OsmesaContext::create({kWidth, kHeight});
  const auto expected = draw(real->real());
  TracedContext ours({kWidth, kHeight});
  const auto got = draw(ours.gl());
  for (const std::string& line : differences(expected.first, got.first)) ADD_FAILURE() << line;
  const Comparison c = compare(expected.second, got.second, {});
  EXPECT_TRUE(c.accepted) << c.text;
}

}  // namespace
}  // namespace gluray::test
