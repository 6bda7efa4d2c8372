// Images of frames record which pixels were traced; taking them does not change OpenGL state.
#include "intercept/present/read_back/frame_image.h"

#include "intercept/present/write_back/write_back.h"
#include "tests/present/images.h"
#include "tests/support/gl_state.h"
#include "tests/support/osmesa_context.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>

namespace gluray::present::test {
namespace {

using gluray::test::ContextWish;
using gluray::test::OsmesaContext;

constexpr int kImageSize = 32;

class FrameImageTest : public testing::TestWithParam<ContextWish> {
 protected:
  void SetUp() override {
    context_ = OsmesaContext::create(GetParam());
    ASSERT_TRUE(context_);
    writeBack_.emplace(gl());
    gl().Enable(GL_DEPTH_TEST);
    gl().ClearColor(0, 0, 1, 1);
    gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }
  const gl::RealGl& gl() const { return context_->real(); }

  void trace(const Image& image) {
    PendingErrors pending;
    ASSERT_TRUE(writeBack_->write(image, {}, pending));
    recorder_.written(gl(), image);
  }
  RecordedImage take() { return recorder_.readFrame(gl(), GL_FRONT, kImageSize, kImageSize, 1); }
  /// Lets the real OpenGL draw a rectangle.
  void paint(int x, int y, int width, int height) {
    gl().Enable(GL_SCISSOR_TEST);
    gl().Scissor(x, y, width, height);
    gl().ClearColor(1, 1, 1, 1);
    gl().Clear(GL_COLOR_BUFFER_BIT);
    gl().Disable(GL_SCISSOR_TEST);
  }
  static int64_t count(const RecordedImage& recorded, PixelOrigin origin) {
    return std::count(recorded.origin.begin(), recorded.origin.end(), origin);
  }

  std::unique_ptr<OsmesaContext> context_;
  std::optional<WriteBack> writeBack_;
  FrameImage recorder_;
};

TEST_P(FrameImageTest, TracedPixelsAreKnown) {
  trace(solid(4, 8, 10, 6, kRed, 0.5f));
  const RecordedImage recorded = take();
  EXPECT_EQ(count(recorded, PixelOrigin::traced), 60);
  EXPECT_EQ(count(recorded, PixelOrigin::drawnOver), 0);
  EXPECT_EQ(recorded.origin[8 * kImageSize + 4], PixelOrigin::traced);
  EXPECT_EQ(recorded.origin[8 * kImageSize + 3], PixelOrigin::rasterised);
  EXPECT_EQ(recorded.color[8 * kImageSize + 4], kRed);
}

TEST_P(FrameImageTest, MissesAndHiddenPixelsAreNotTraced) {
  Image image = solid(0, 0, 8, 8, kRed, 0.5f);
  image.depth[0] = Image::kMiss;
  trace(image);
  trace(solid(0, 0, 8, 4, kGreen, 0.75f));  // behind it, except at the miss
  const RecordedImage recorded = take();
  EXPECT_EQ(count(recorded, PixelOrigin::traced), 64);
  EXPECT_EQ(recorded.color[0], kGreen);
  EXPECT_EQ(recorded.color[1], kRed);
}

TEST_P(FrameImageTest, PixelsDrawnOverAreMarked) {
  trace(solid(0, 0, 10, 10, kRed, 0.5f));
  paint(8, 8, 4, 4);
  const RecordedImage recorded = take();
  EXPECT_EQ(count(recorded, PixelOrigin::traced), 96);
  EXPECT_EQ(count(recorded, PixelOrigin::drawnOver), 4);
}

TEST_P(FrameImageTest, TheNextFrameStartsAfresh) {
  trace(solid(0, 0, 10, 10, kRed, 0.5f));
  take();
  EXPECT_EQ(count(take(), PixelOrigin::traced), 0);
}

TEST_P(FrameImageTest, OtherFramebuffersAreCountedSeparately) {
  GLuint framebuffer = 0, planes[2] = {};
  gl().GenFramebuffers(1, &framebuffer);
  gl().GenRenderbuffers(2, planes);
  gl().BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLenum formats[2] = {GL_RGBA8, GL_DEPTH_COMPONENT24},
               points[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    gl().BindRenderbuffer(GL_RENDERBUFFER, planes[i]);
    gl().RenderbufferStorage(GL_RENDERBUFFER, formats[i], kImageSize, kImageSize);
    gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, points[i], GL_RENDERBUFFER, planes[i]);
  }
  gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  trace(solid(0, 0, 5, 5, kRed, 0.5f));
  const RecordedImage recorded = take();  // of the window, whatever is bound
  EXPECT_EQ(count(recorded, PixelOrigin::traced), 0);
  EXPECT_EQ(recorded.elsewhere, 25u);
  EXPECT_EQ(recorded.color[0], 0xffff0000u);
}

TEST_P(FrameImageTest, NoStateChanges) {
  gl().PixelStorei(GL_PACK_ROW_LENGTH, 7);
  gl().PixelStorei(GL_PACK_SKIP_PIXELS, 3);
  gl().PixelStorei(GL_PACK_SWAP_BYTES, 1);
  GLuint buffer = 0;
  gl().GenBuffers(1, &buffer);
  gl().BindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  if (!GetParam().core) {
    gl().PixelTransferf(GL_RED_SCALE, 0.5f);
    gl().PixelTransferf(GL_DEPTH_BIAS, 0.25f);
    gl().PixelTransferf(GL_MAP_COLOR, 1);
  }
  const Image image = solid(0, 0, 8, 8, kRed, 0.5f);
  PendingErrors pending;
  ASSERT_TRUE(writeBack_->write(image, {}, pending));
  const gluray::test::GlState before = gluray::test::queryState(gl());
  recorder_.written(gl(), image);
  const RecordedImage recorded = take();
  EXPECT_EQ(gluray::test::differences(before, gluray::test::queryState(gl())), std::vector<std::string>{});
  EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
  EXPECT_EQ(count(recorded, PixelOrigin::traced), 64);
  EXPECT_EQ(recorded.color[0], kRed);
}

INSTANTIATE_TEST_SUITE_P(Contexts, FrameImageTest,
                         testing::Values(ContextWish{kImageSize, kImageSize},
                                         ContextWish{kImageSize, kImageSize, true, 3, 3}));

TEST(FrameImageFiles, HoldTheTopRowFirst) {
  RecordedImage recorded;
  recorded.width = 2, recorded.height = 2;
  recorded.color = {0xff030201, 0xff060504, 0xff090807, 0xff0c0b0a};
  recorded.origin = {PixelOrigin::rasterised, PixelOrigin::traced, PixelOrigin::drawnOver,
                     PixelOrigin::rasterised};
  const std::string base = testing::TempDir() + "/frame_image" + std::to_string(getpid());
  ASSERT_TRUE(writeImage(recorded, base));
  const auto text = [&](const char* suffix) {
    std::ifstream file(base + suffix, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(text(".ppm"), "P6\n2 2\n255\n\x07\x08\x09\x0a\x0b\x0c\x01\x02\x03\x04\x05\x06");
  using namespace std::string_literals;
  EXPECT_EQ(text(".origin.pgm"), "P5\n2 2\n255\n\x80\x00\x00\xff"s);
  EXPECT_FALSE(writeImage(recorded, "/dev/null/image"));
  for (const char* suffix : {".ppm", ".origin.pgm"}) std::remove((base + suffix).c_str());
}

}  // namespace
}  // namespace gluray::present::test
