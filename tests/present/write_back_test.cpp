// The write-back puts exactly the hit pixels into whatever framebuffer is bound, merged by depth.
#include "tests/present/write_back_stage.h"

namespace gluray::present::test {
namespace {

class WriteBackTest : public WriteBackStage {};
INSTANTIATE_TEST_SUITE_P(Contexts, WriteBackTest, allContexts(), nameOf);

TEST_P(WriteBackTest, WritesHitsAndLeavesMisses) {
  write(checkerboard(10, 20, 30, 15, kRed, 0.25f));
  const auto colors = context_->colors();
  const auto depths = context_->depths();
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const bool hit = x >= 10 && x < 40 && y >= 20 && y < 35 && isHit(x - 10, y - 20);
      ASSERT_EQ(at(colors, x, y), hit ? kRed : kBlue) << x << "," << y;
      ASSERT_NEAR(at(depths, x, y), hit ? 0.25f : 1.0f, 1e-7f) << x << "," << y;
    }
}

TEST_P(WriteBackTest, KeepsColourAndDepthOfEachPixelExactly) {
  Image image;
  image.resize(kSize, kSize, 1);
  for (uint32_t i = 0; i < image.color.size(); ++i) {
    image.color[i] = i * 2654435761u;
    image.depth[i] = static_cast<float>(i * 4099 % 16777216) / 16777215.0f;
  }
  write(image);
  EXPECT_EQ(context_->colors(), image.color);
  const auto depths = context_->depths();
  for (size_t i = 0; i < depths.size(); ++i) ASSERT_NEAR(depths[i], image.depth[i], 1.2e-7f);
}

TEST_P(WriteBackTest, MergesWithWhatWasDrawnBefore) {
  clearRectangle(0, 0, 32, kSize, 0, 1, 0, 0.2);
  write(solid(0, 0, kSize, kSize, kRed, 0.5f));
  const auto colors = context_->colors();
  EXPECT_EQ(at(colors, 5, 5), kGreen);
  EXPECT_EQ(at(colors, 40, 5), kRed);
  EXPECT_NEAR(at(context_->depths(), 40, 5), 0.5f, 1e-7f);
}

TEST_P(WriteBackTest, OverAFinishedImageHidesWhateverIsThereAndLeavesItsDepth) {
  clear(0, 1, 0, 0.25);
  const auto before = context_->depths();
  const Image image = solid(8, 8, 16, 8, kRed, 0.5f);  // behind the framebuffer's content
  std::string why;
  ASSERT_TRUE(writeBack_->ready(why)) << why;
  ASSERT_TRUE(writeBack_->write(image, {.over = GL_FRONT}, pending_));
  const auto colors = context_->colors();
  EXPECT_EQ(at(colors, 8, 8), kRed);
  EXPECT_EQ(at(colors, 23, 15), kRed);
  EXPECT_EQ(at(colors, 24, 8), kGreen);
  EXPECT_EQ(at(colors, 8, 16), kGreen);
  EXPECT_EQ(context_->depths(), before);
}

TEST_P(WriteBackTest, EqualDepthObeysTheDepthFunction) {
  clear(0, 1, 0, 0.5);
  const float stored = context_->depths()[0];
  write(solid(0, 0, kSize, kSize, kRed, stored), GL_LESS);
  EXPECT_EQ(context_->colors()[0], kGreen);
  write(solid(0, 0, kSize, kSize, kRed, stored), GL_LEQUAL);
  EXPECT_EQ(context_->colors()[0], kRed);
}

TEST_P(WriteBackTest, IgnoresTheProgramsState) {
  const auto& g = gl();
  g.Enable(GL_SCISSOR_TEST), g.Scissor(1, 1, 2, 2);
  g.Viewport(3, 3, 5, 5);
  g.DepthRange(0.9, 0.1), g.DepthMask(GL_FALSE), g.DepthFunc(GL_NEVER);
  g.ColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
  g.Enable(GL_BLEND), g.BlendFunc(GL_ZERO, GL_ZERO);
  g.Enable(GL_STENCIL_TEST), g.StencilFunc(GL_NEVER, 1, 1);
  g.Enable(GL_CULL_FACE), g.CullFace(GL_FRONT_AND_BACK);
  g.Enable(GL_COLOR_LOGIC_OP), g.LogicOp(GL_CLEAR);
  g.PolygonMode(GL_FRONT_AND_BACK, GL_POINT);
  g.Enable(GL_RASTERIZER_DISCARD);
  g.PixelStorei(GL_UNPACK_ROW_LENGTH, 3), g.PixelStorei(GL_UNPACK_SKIP_PIXELS, 7);
  g.PixelStorei(GL_UNPACK_SWAP_BYTES, GL_TRUE), g.PixelStorei(GL_UNPACK_ALIGNMENT, 8);
  if (!GetParam().core) {
    g.PixelTransferf(GL_RED_SCALE, 0), g.PixelTransferf(GL_GREEN_BIAS, 1);
    g.Enable(GL_ALPHA_TEST), g.AlphaFunc(GL_NEVER, 0);
    g.Enable(GL_CLIP_PLANE0);
    const GLdouble nothing[4] = {0, 0, 0, -1};
    g.ClipPlane(GL_CLIP_PLANE0, nothing);
    g.Enable(GL_POLYGON_STIPPLE);
  }
  write(solid(0, 0, kSize, kSize, kRed, 0.5f));
  if (!GetParam().core)
    g.PixelTransferf(GL_RED_SCALE, 1), g.PixelTransferf(GL_GREEN_BIAS, 0);  // they also affect reading
  EXPECT_EQ(context_->colors(), std::vector<uint32_t>(kSize * kSize, kRed));
}

TEST_P(WriteBackTest, AKnownImageIsWrittenAgainUntilAnotherIs) {
  const Image red = checkerboard(0, 0, kSize, kSize, kRed, 0.25f), green = solid(0, 0, 20, 20, kGreen, 0.1f);
  const auto writeNumbered = [&](const Image& image, uint64_t number) {
    ASSERT_TRUE(writeBack_->write(image, {GL_LEQUAL, number}, pending_));
  };
  writeNumbered(red, 1);
  const auto once = context_->colors();
  for (int again = 0; again < 3; ++again) {
    clear(0, 0, 1, 1);
    writeNumbered(red, 1);
    ASSERT_EQ(context_->colors(), once);
  }
  writeNumbered(green, 2);
  EXPECT_EQ(at(context_->colors(), 3, 4), kGreen);
  clear(0, 0, 1, 1);
  writeNumbered(red, 1);
  EXPECT_EQ(context_->colors(), once);
  clear(0, 0, 1, 1);
  writeNumbered(green, 0);
  writeNumbered(red, 1);
  EXPECT_EQ(at(context_->colors(), 3, 4), kGreen);
  EXPECT_EQ(at(context_->colors(), 30, 40), at(once, 30, 40));
}

TEST_P(WriteBackTest, SmallerAndLargerImagesShareTheTextures) {
  write(solid(0, 0, 8, 8, kRed, 0.5f));
  write(solid(8, 0, 56, 4, kGreen, 0.5f));
  write(checkerboard(20, 20, 3, 40, kRed, 0.5f));
  const auto colors = context_->colors();
  EXPECT_EQ(at(colors, 7, 7), kRed);
  EXPECT_EQ(at(colors, 63, 3), kGreen);
  EXPECT_EQ(at(colors, 63, 4), kBlue);
  EXPECT_EQ(at(colors, 20, 20), kRed);
  EXPECT_EQ(at(colors, 21, 20), kBlue);
  EXPECT_EQ(at(colors, 21, 59), kRed);
}

TEST_P(WriteBackTest, HandsBackErrorsOfTheProgram) {
  gl().Enable(0xdead);
  write(solid(0, 0, 8, 8, kRed, 0.5f));
  EXPECT_EQ(pending_, PendingErrors{GL_INVALID_ENUM});
}

TEST_P(WriteBackTest, ReleasedObjectsAreMadeAgain) {
  write(solid(0, 0, 8, 8, kRed, 0.5f));
  writeBack_->release();
  write(solid(0, 0, 8, 8, kGreen, 0.4f));
  EXPECT_EQ(context_->colors()[0], kGreen);
}

/// Core contexts generate every name.
class WriteBackNames : public WriteBackStage {};
INSTANTIATE_TEST_SUITE_P(Contexts, WriteBackNames, compatibilityContexts(), nameOf);

TEST_P(WriteBackNames, AProgramsOwnTextureNamesStayItsOwn) {
  write(solid(0, 0, 8, 8, kRed, 0.5f));
  for (GLuint name = 1; name < 2000; ++name) ASSERT_FALSE(gl().IsTexture(name)) << name;
}

}  // namespace
}  // namespace gluray::present::test
