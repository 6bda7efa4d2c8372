// Texture images are read from the real OpenGL again only after calls that may have changed them.
#include "scenes/stage.h"
#include "scenes/texels.h"
#include "tests/support/snapshot_taker.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <memory>

namespace gluray::test {
namespace {

using namespace scenes;
using TakenImage = std::shared_ptr<const scene::TextureImage>;

/// Puts the texture image of the last batch into `image`.
std::unique_ptr<gl::Presenter> takeImage(TakenImage& image) {
  return std::make_unique<SnapshotTaker>([&image](const scene::Snapshot& s) {
    const auto& textures = s.shadings.back().textures;
    image = textures.empty() ? nullptr : textures[0].image;
  });
}

class TextureCache : public testing::Test {
 protected:
  TakenImage last;
  TracedContext context{{64, 64}, TracedContext::vertexShading(), takeImage(last)};
  Gl gl = context.gl();
  GLuint texture = 0;

  void SetUp() override {
    begin(gl, 64, 64);
    camera(gl, 64, 64);
    gl.Enable(GL_TEXTURE_2D);
    texture = fresh();
  }
  GLuint fresh() {
    const GLuint name = bindFresh(gl, GL_TEXTURE_2D);
    scenes::upload(gl, GL_RGBA8, 8, GL_NEAREST, GL_REPEAT);
    return name;
  }
  /// The texture image with which a surface is drawn now.
  TakenImage drawn(GLuint name) {
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl.BindTexture(GL_TEXTURE_2D, name);
    send(gl, scenes::sphere(6, 8), kTexcoords);
    gl.Finish();
    return last;
  }
};

TEST_F(TextureCache, BitmapsInListsChangeNoTexture) {
  const GLubyte bits[] = {0xFF};
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.Bitmap(8, 1, 0, 0, 0, 0, bits);
  gl.EndList();
  const TakenImage first = drawn(texture);
  ASSERT_NE(first, nullptr);
  gl.CallList(list);
  EXPECT_EQ(drawn(texture), first);
}

TEST_F(TextureCache, UploadsInListsDo) {
  const uint32_t red = 0xFF0000FF;
  const GLuint list = gl.GenLists(1);
  gl.NewList(list, GL_COMPILE);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &red);
  gl.EndList();
  ASSERT_NE(drawn(texture), nullptr);
  gl.CallList(list);
  EXPECT_EQ(drawn(texture)->texels[0], red);
}

TEST_F(TextureCache, DrawingIntoATextureChangesThatOneOnly) {
  const GLuint target = fresh();
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  const TakenImage other = drawn(texture), before = drawn(target);
  ASSERT_NE(before, nullptr);
  gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.ClearColor(0, 1, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  EXPECT_EQ(drawn(texture), other);
  EXPECT_EQ(drawn(target)->texels[0], 0xFF00FF00);
}

}  // namespace
}  // namespace gluray::test
