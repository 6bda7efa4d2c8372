// Images uploaded into textures equal drawn ones.
#include "intercept/present/write_back/texture_upload.h"

#include "intercept/present/write_back/cleared_color.h"
#include "intercept/present/write_back/write_back.h"
#include "tests/support/osmesa_context.h"

#include <gtest/gtest.h>

#include <random>

namespace gluray::present {
namespace {

constexpr int kUploadSize = 64;

struct Target {
  GLuint framebuffer = 0;
};

Target make(const gl::RealGl& g, GLenum depthFormat) {
  Target t;
  GLuint textures[2] = {};
  g.GenTextures(2, textures);
  g.BindTexture(GL_TEXTURE_2D, textures[0]);
  g.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kUploadSize, kUploadSize, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  g.BindTexture(GL_TEXTURE_2D, textures[1]);
  const bool packed = depthFormat == GL_DEPTH24_STENCIL8;
  g.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(depthFormat), kUploadSize, kUploadSize, 0,
               packed ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT,
               packed ? GLenum{GL_UNSIGNED_INT_24_8} : GLenum{GL_FLOAT}, nullptr);
  g.BindTexture(GL_TEXTURE_2D, 0);
  g.GenFramebuffers(1, &t.framebuffer), g.BindFramebuffer(GL_FRAMEBUFFER, t.framebuffer);
  g.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, textures[0], 0);
  g.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, textures[1], 0);
  g.ClearColor(0.2f, 0.4f, 0.61f, 0.5f), g.ClearDepth(1);
  g.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return t;
}

/// Hits with all kinds of depths in a corner of the framebuffer, and misses.
Image noise(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> depth(0, 1);
  Image image;
  image.x = 5, image.y = 9;
  image.resize(50, 40, 1);
  for (size_t i = 0; i < image.color.size(); ++i) {
    image.color[i] = static_cast<uint32_t>(random());
    const uint32_t kind = random() % 8;
    image.depth[i] = kind == 0   ? Image::kMiss
                     : kind == 1 ? 1.0f - depth(random) * 0x1p-20f  // where a projection puts most of a scene
                     : kind == 2 ? static_cast<float>((random() % 16777216) / 16777215.0)
                     : kind == 3
                         ? static_cast<float>((random() % 16777215 + 0.5) / 16777215.0)  // between two
                         : depth(random);
  }
  image.depth[0] = 0, image.depth[1] = 1;
  return image;
}

struct Read {
  std::vector<uint32_t> colors, depths;
  bool operator==(const Read&) const = default;
};

Read read(const gl::RealGl& g) {
  Read r{std::vector<uint32_t>(kUploadSize * kUploadSize), std::vector<uint32_t>(kUploadSize * kUploadSize)};
  g.ReadPixels(0, 0, kUploadSize, kUploadSize, GL_RGBA, GL_UNSIGNED_BYTE, r.colors.data());
  g.ReadPixels(0, 0, kUploadSize, kUploadSize, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, r.depths.data());
  return r;
}

gl::ClearedTarget clearedOf(const Target& t) {
  return {t.framebuffer, {0, 0, kUploadSize, kUploadSize}, {0.2f, 0.4f, 0.61f, 0.5f}};
}

class TextureUploadTest : public testing::TestWithParam<std::pair<GLenum, gluray::test::ContextWish>> {};

TEST_P(TextureUploadTest, EqualsADrawnImage) {
  const auto [format, wish] = GetParam();
  const auto context = gluray::test::OsmesaContext::create(wish);
  ASSERT_TRUE(context);
  const gl::RealGl& g = context->real();
  const Features features = readFeatures(g);
  g.DepthFunc(GL_LEQUAL), g.Enable(GL_DEPTH_TEST);
  WriteBack writeBack(g);
  TextureUpload put;
  ClearedColor cleared;
  for (const unsigned seed : {1u, 2u, 3u}) {
    Image image = noise(seed);
    PendingErrors pending;
    make(g, format);
    ASSERT_TRUE(writeBack.write(image, {GL_LEQUAL}, pending));
    const Read drawn = read(g);
    const Target target = make(g, format);
    const std::optional<uint32_t> background = cleared.bits(g, features, clearedOf(target), pending);
    ASSERT_TRUE(background);
    for (size_t i = 0; i < image.color.size(); ++i)
      if (image.depth[i] == Image::kMiss) image.color[i] = *background;
    ASSERT_TRUE(put.put(g, features, image, 2, pending));
    EXPECT_EQ(read(g), drawn) << "seed " << seed;
    EXPECT_TRUE(pending.empty());
    EXPECT_EQ(g.GetError(), GLenum{GL_NO_ERROR});
  }
}

INSTANTIATE_TEST_SUITE_P(
    Formats, TextureUploadTest,
    testing::Values(std::pair(GLenum{GL_DEPTH24_STENCIL8}, gluray::test::ContextWish{}),
                    std::pair(GLenum{GL_DEPTH_COMPONENT32F}, gluray::test::ContextWish{}),
                    std::pair(GLenum{GL_DEPTH24_STENCIL8},
                              gluray::test::ContextWish{.core = true, .major = 3, .minor = 2})));

TEST(TextureUpload, RefusesWhatItDoesNotKnow) {
  const auto context = gluray::test::OsmesaContext::create();
  ASSERT_TRUE(context);
  const gl::RealGl& g = context->real();
  const Features features = readFeatures(g);
  PendingErrors pending;
  TextureUpload put;
  for (const GLenum format : {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32}) {
    make(g, format);
    EXPECT_FALSE(put.put(g, features, noise(1), 2, pending));
  }
  make(g, GL_DEPTH24_STENCIL8);
  Image large = noise(1);
  large.x = 20;  // beyond the texture
  EXPECT_FALSE(put.put(g, features, large, 2, pending));
  Image averages = noise(1);
  averages.planes = averages.planes | Plane::centerDepth;
  averages.centerDepth = averages.depth;
  EXPECT_FALSE(put.put(g, features, averages, 2, pending));
  GLuint renderbuffer = 0;
  g.GenRenderbuffers(1, &renderbuffer), g.BindRenderbuffer(GL_RENDERBUFFER, renderbuffer);
  g.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kUploadSize, kUploadSize);
  g.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, renderbuffer);
  EXPECT_FALSE(put.put(g, features, noise(1), 2, pending));
  EXPECT_EQ(g.GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace gluray::present
