// The write-back into framebuffer objects, and beyond their edges.
#include "tests/present/write_back_stage.h"

namespace gluray::present::test {
namespace {

class WriteBackFramebuffers : public WriteBackStage {};
INSTANTIATE_TEST_SUITE_P(Contexts, WriteBackFramebuffers, allContexts(), nameOf);

TEST_P(WriteBackFramebuffers, OverTheWindowWhicheverFramebufferIsBound) {
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

TEST_P(WriteBackFramebuffers, WritesIntoAFramebufferObject) {
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

TEST_P(WriteBackFramebuffers, WritesEachSampleOfAMultisampledFramebuffer) {
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

}  // namespace
}  // namespace gluray::present::test
