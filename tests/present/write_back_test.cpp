// The write-back puts exactly the hit pixels into whatever framebuffer is bound, merged by depth.
#include "intercept/present/write_back/write_back.h"

#include "tests/support/osmesa_context.h"

#include <gtest/gtest.h>

#include <optional>

namespace gluray::present {
namespace {

using test::ContextWish;
using test::OsmesaContext;

constexpr uint32_t kRed = 0xff0000ff, kGreen = 0xff00ff00, kBlue = 0xffff0000;
constexpr int kSize = 64;

bool isHit(int x, int y) { return (x + y) % 2 == 0; }

/// A picture whose pixels with x + y even (counted within the picture) are hits of `color` at `depth`.
Image checkerboard(int x, int y, int width, int height, uint32_t color, float depth, int samples = 1) {
  Image image;
  image.x = x, image.y = y;
  image.resize(width, height, samples);
  for (int s = 0; s < samples; ++s)
    for (int row = 0; row < height; ++row)
      for (int column = 0; column < width; ++column) {
        const auto i = static_cast<size_t>((s * height + row) * width + column);
        image.color[i] = isHit(column, row) ? color : 0;
        image.depth[i] = isHit(column, row) ? depth : Image::kMiss;
      }
  return image;
}

Image solid(int x, int y, int width, int height, uint32_t color, float depth) {
  Image image;
  image.x = x, image.y = y;
  image.resize(width, height, 1);
  image.color.assign(image.color.size(), color);
  image.depth.assign(image.depth.size(), depth);
  return image;
}

class WriteBackTest : public testing::TestWithParam<ContextWish> {
 protected:
  void SetUp() override {
    context_ = OsmesaContext::create(GetParam());
    ASSERT_TRUE(context_);
    writeBack_.emplace(gl());
    gl().Enable(GL_DEPTH_TEST);
    clear(0, 0, 1, 1);
  }
  const gl::RealGl& gl() const { return context_->real(); }

  void clear(float r, float g, float b, double depth) const {
    gl().ClearColor(r, g, b, 1);
    gl().ClearDepth(depth);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  /// What raster drawing of a nearer or farther rectangle leaves behind, without needing a program.
  void clearRectangle(int x, int y, int width, int height, float r, float g, float b, double depth) const {
    gl().Enable(GL_SCISSOR_TEST);
    gl().Scissor(x, y, width, height);
    clear(r, g, b, depth);
    gl().Disable(GL_SCISSOR_TEST);
  }
  void write(const Image& image, GLenum func = GL_LEQUAL) {
    std::string why;
    ASSERT_TRUE(writeBack_->ready(why)) << why;
    ASSERT_TRUE(writeBack_->write(image, {func}, pending_));
    EXPECT_EQ(gl().GetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
  static uint32_t at(const std::vector<uint32_t>& pixels, int x, int y) {
    return pixels[static_cast<size_t>(y * kSize + x)];
  }
  static float at(const std::vector<float>& pixels, int x, int y) {
    return pixels[static_cast<size_t>(y * kSize + x)];
  }

  std::unique_ptr<OsmesaContext> context_;
  std::optional<WriteBack> writeBack_;
  PendingErrors pending_;
};

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

TEST_P(WriteBackTest, OverAFinishedPictureHidesWhateverIsThereAndLeavesItsDepth) {
  clear(0, 1, 0, 0.25);
  const auto before = context_->depths();
  const Image image = solid(8, 8, 16, 8, kRed, 0.5f);  // behind what is there
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

TEST_P(WriteBackTest, OverTheWindowWhicheverFramebufferIsBound) {
  const auto& g = gl();
  if (!gl::isPresent(g.BindFramebuffer)) GTEST_SKIP() << "no framebuffer objects";
  GLuint framebuffer = 0, color = 0;
  g.GenFramebuffers(1, &framebuffer), g.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  g.GenRenderbuffers(1, &color), g.BindRenderbuffer(GL_RENDERBUFFER, color);
  g.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSize, kSize);
  g.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
  clear(0, 1, 0, 1);
  std::string why;
  ASSERT_TRUE(writeBack_->ready(why)) << why;
  ASSERT_TRUE(writeBack_->write(solid(8, 8, 16, 8, kRed, 0), {.over = GL_FRONT}, pending_));
  GLint bound = 0;
  g.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  EXPECT_EQ(bound, static_cast<GLint>(framebuffer));
  EXPECT_EQ(at(context_->colors(), 8, 8), kGreen);
  g.BindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(at(context_->colors(), 8, 8), kRed);
}

TEST_P(WriteBackTest, EqualDepthObeysTheDepthFunction) {
  clear(0, 1, 0, 0.5);
  const float stored = context_->depths()[0];
  write(solid(0, 0, kSize, kSize, kRed, stored), GL_LESS);
  EXPECT_EQ(context_->colors()[0], kGreen);
  write(solid(0, 0, kSize, kSize, kRed, stored), GL_LEQUAL);
  EXPECT_EQ(context_->colors()[0], kRed);
}

TEST_P(WriteBackTest, IgnoresTheStateOfTheMoment) {
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
    g.PixelTransferf(GL_RED_SCALE, 1), g.PixelTransferf(GL_GREEN_BIAS, 0);  // they act on reading too
  EXPECT_EQ(context_->colors(), std::vector<uint32_t>(kSize * kSize, kRed));
}

/// Averages: column x is covered x / kSize by red, at its centre from the middle on.
Image averages(float depth) {
  Image image;
  image.resize(kSize, kSize, 1, Image::kPicture | Plane::centerDepth);
  for (int i = 0; i < kSize * kSize; ++i) {
    const int x = i % kSize;
    const auto share = static_cast<uint32_t>(255 * x / kSize);
    image.color[static_cast<size_t>(i)] = share | share << 24;
    image.depth[static_cast<size_t>(i)] = x > 0 ? depth : Image::kMiss;
    image.centerDepth[static_cast<size_t>(i)] = x >= kSize / 2 ? depth : Image::kMiss;
  }
  return image;
}

TEST_P(WriteBackTest, AveragesAreBlendedOverAndLeaveTheDepthOfTheirCentres) {
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

TEST_P(WriteBackTest, AKnownPictureIsWrittenAgainUntilAnotherIs) {
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

TEST_P(WriteBackTest, AveragesBehindWhatIsThereAreNotSeen) {
  clear(0, 1, 0, 0.2);
  write(averages(0.25f));
  EXPECT_EQ(context_->colors(), std::vector<uint32_t>(kSize * kSize, kGreen));
  EXPECT_NEAR(context_->depths()[kSize - 1], 0.2f, 1e-7f);
}

TEST_P(WriteBackTest, AveragesLeaveTheStateAlone) {
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

TEST_P(WriteBackTest, WritesIntoAFramebufferObject) {
  const auto& g = gl();
  GLuint fbo = 0, buffers[2];
  g.GenFramebuffers(1, &fbo);
  g.GenRenderbuffers(2, buffers);
  g.BindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
  g.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSize, kSize);
  g.BindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
  g.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, kSize, kSize);
  g.BindFramebuffer(GL_FRAMEBUFFER, fbo);
  g.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
  g.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
  ASSERT_EQ(g.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  clear(0, 1, 0, 1);
  write(checkerboard(0, 0, kSize, kSize, kRed, 0.3f));
  EXPECT_EQ(at(context_->colors(), 0, 0), kRed);
  EXPECT_EQ(at(context_->colors(), 1, 0), kGreen);
  EXPECT_EQ(at(context_->depths(), 0, 0), 0.3f);
  g.BindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(at(context_->colors(), 0, 0), kBlue);
}

TEST_P(WriteBackTest, WritesEachSampleOfAMultisampledFramebuffer) {
  const auto& g = gl();
  constexpr int kSamples = 4;
  GLuint fbos[2], buffers[3];
  g.GenFramebuffers(2, fbos);
  g.GenRenderbuffers(3, buffers);
  g.BindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
  g.RenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, GL_RGBA8, kSize, kSize);
  g.BindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
  g.RenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, GL_DEPTH_COMPONENT24, kSize, kSize);
  g.BindRenderbuffer(GL_RENDERBUFFER, buffers[2]);
  g.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kSize, kSize);
  g.BindFramebuffer(GL_FRAMEBUFFER, fbos[1]);
  g.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[2]);
  g.BindFramebuffer(GL_FRAMEBUFFER, fbos[0]);
  g.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
  g.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
  ASSERT_EQ(g.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  clear(0, 0, 1, 1);

  // Column x has x % 5 of its four samples hit, in red.
  Image image = solid(0, 0, kSize, kSize, kRed, Image::kMiss);
  image.resize(kSize, kSize, kSamples);
  for (int s = 0; s < kSamples; ++s)
    for (int i = 0; i < kSize * kSize; ++i) {
      const auto k = static_cast<size_t>(s * kSize * kSize + i);
      image.color[k] = kRed;
      image.depth[k] = s < (i % kSize) % 5 ? 0.25f : Image::kMiss;
    }
  write(image);
  g.BindFramebuffer(GL_READ_FRAMEBUFFER, fbos[0]);
  g.BindFramebuffer(GL_DRAW_FRAMEBUFFER, fbos[1]);
  g.BlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  g.BindFramebuffer(GL_FRAMEBUFFER, fbos[1]);
  const auto colors = context_->colors();
  for (int x = 0; x < kSize; ++x) {
    const int red = static_cast<int>(at(colors, x, 7) & 0xff);
    ASSERT_NEAR(red, (x % 5) * 255 / kSamples, 1) << x;
  }
}

TEST_P(WriteBackTest, SmallerAndLargerPicturesShareTheTextures) {
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

TEST_P(WriteBackTest, AProgramsOwnTextureNamesStayItsOwn) {
  if (GetParam().core) GTEST_SKIP() << "core contexts generate every name";
  write(solid(0, 0, 8, 8, kRed, 0.5f));
  for (GLuint name = 1; name < 2000; ++name) ASSERT_FALSE(gl().IsTexture(name)) << name;
}

TEST_P(WriteBackTest, ReleasedObjectsAreMadeAgain) {
  write(solid(0, 0, 8, 8, kRed, 0.5f));
  writeBack_->release();
  write(solid(0, 0, 8, 8, kGreen, 0.4f));
  EXPECT_EQ(context_->colors()[0], kGreen);
}

std::string nameOf(const testing::TestParamInfo<ContextWish>& info) {
  const ContextWish& w = info.param;
  return std::string(w.core ? "core" : "compat") + std::to_string(w.major) + std::to_string(w.minor);
}

INSTANTIATE_TEST_SUITE_P(Contexts, WriteBackTest,
                         testing::Values(ContextWish{kSize, kSize, false, 0, 0},
                                         ContextWish{kSize, kSize, false, 2, 1},
                                         ContextWish{kSize, kSize, true, 3, 2},
                                         ContextWish{kSize, kSize, true, 4, 5}),
                         nameOf);

}  // namespace
}  // namespace gluray::present
