// Averages of samples are blended over the framebuffer's content.
#include "tests/present/write_back_stage.h"

namespace gluray::present::test {
namespace {

/// Averages: column x is covered x / kSize by red, at its centre from the middle on.
Image averages(float depth) {
  Image image;
  image.resize(kSize, kSize, 1, Image::kColorDepth | Plane::centerDepth);
  for (int i = 0; i < kSize * kSize; ++i) {
    const int x = i % kSize;
    const auto share = static_cast<uint32_t>(255 * x / kSize);
    image.color[static_cast<size_t>(i)] = share | share << 24;
    image.depth[static_cast<size_t>(i)] = x > 0 ? depth : Image::kMiss;
    image.centerDepth[static_cast<size_t>(i)] = x >= kSize / 2 ? depth : Image::kMiss;
  }
  return image;
}

class WriteBackAverages : public WriteBackStage {};
INSTANTIATE_TEST_SUITE_P(Contexts, WriteBackAverages, allContexts(), nameOf);

TEST_P(WriteBackAverages, AreBlendedOverAndLeaveTheDepthOfTheirCentres) {
  clear(0, 1, 0, 1);
  write(averages(0.25f));
  const auto colors = context_->colors();
  const auto depths = context_->depths();
  for (int x = 0; x < kSize; ++x) {
    const int red = 255 * x / kSize;
    EXPECT_EQ(static_cast<int>(at(colors, x, 9) & 255), red) << x;
    EXPECT_NEAR(static_cast<int>(at(colors, x, 9) >> 8 & 255), 255 - red, 1) << x;
    EXPECT_NEAR(static_cast<int>(at(colors, x, 9) >> 24), 255, 1) << x;
    EXPECT_NEAR(at(depths, x, 9), x >= kSize / 2 ? 0.25f : 1.0f, 1e-7f) << x;
  }
}

TEST_P(WriteBackAverages, BehindExistingDepthAreHidden) {
  clear(0, 1, 0, 0.2);
  write(averages(0.25f));
  EXPECT_EQ(context_->colors(), std::vector<uint32_t>(kSize * kSize, kGreen));
  EXPECT_NEAR(context_->depths()[kSize - 1], 0.2f, 1e-7f);
}

TEST_P(WriteBackAverages, LeaveTheStateAlone) {
  const auto& g = gl();
  g.Enable(GL_BLEND), g.BlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ONE, GL_SRC_ALPHA);
  g.BlendEquationSeparate(GL_FUNC_SUBTRACT, GL_MAX);
  g.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  g.DepthMask(GL_FALSE);
  write(averages(0.25f));
  const auto is = [&](GLenum name) {
    GLint value = 0;
    g.GetIntegerv(name, &value);
    return value;
  };
  EXPECT_TRUE(g.IsEnabled(GL_BLEND));
  EXPECT_EQ(is(GL_BLEND_SRC_RGB), GL_DST_COLOR);
  EXPECT_EQ(is(GL_BLEND_DST_RGB), GL_ZERO);
  EXPECT_EQ(is(GL_BLEND_SRC_ALPHA), GL_ONE);
  EXPECT_EQ(is(GL_BLEND_DST_ALPHA), GL_SRC_ALPHA);
  EXPECT_EQ(is(GL_BLEND_EQUATION_RGB), GL_FUNC_SUBTRACT);
  EXPECT_EQ(is(GL_BLEND_EQUATION_ALPHA), GL_MAX);
  EXPECT_EQ(is(GL_DEPTH_WRITEMASK), GL_FALSE);
  GLboolean mask[4];
  g.GetBooleanv(GL_COLOR_WRITEMASK, mask);
  EXPECT_EQ(std::vector<int>(mask, mask + 4), (std::vector<int>{0, 1, 0, 1}));
}

}  // namespace
}  // namespace gluray::present::test
