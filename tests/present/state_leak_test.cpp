// A write-back changes no queryable state, whatever the program had set.
#include "base/sanitized.h"
#include "intercept/present/read_back/window_buffers.h"
#include "intercept/present/write_back/write_back.h"
#include "tests/support/gl_state.h"
#include "tests/support/osmesa_context.h"

#include <gtest/gtest.h>

#include <vector>

namespace gluray::present {
namespace {

using gluray::test::ContextWish;
using gluray::test::OsmesaContext;

/// Moves every piece of state that the write-back touches away from its default, where the context has it.
void unusualState(const gl::RealGl& gl, bool core) {
  gl.Viewport(1, 2, 30, 31);
  gl.DepthRange(0.75, 0.25);
  gl.Scissor(3, 4, 5, 6);
  for (GLenum cap :
       {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_COLOR_LOGIC_OP, GL_POLYGON_OFFSET_FILL,
        GL_POLYGON_SMOOTH, GL_SAMPLE_ALPHA_TO_COVERAGE, GL_SAMPLE_COVERAGE, GL_RASTERIZER_DISCARD,
        GL_SAMPLE_MASK, GL_DEPTH_CLAMP, GL_FRAMEBUFFER_SRGB, GL_PRIMITIVE_RESTART})
    gl.Enable(cap);
  for (GLenum cap = GL_CLIP_PLANE0; cap < GL_CLIP_PLANE0 + 4; ++cap) gl.Enable(cap);
  gl.Disable(GL_MULTISAMPLE), gl.Disable(GL_DITHER);
  gl.SampleMaski(0, 5), gl.SampleCoverage(0.5f, GL_TRUE);
  gl.DepthFunc(GL_GREATER), gl.DepthMask(GL_FALSE);
  gl.LogicOp(GL_XOR), gl.BlendFunc(GL_ONE, GL_ONE);
  gl.StencilFunc(GL_EQUAL, 3, 7), gl.StencilMask(9);
  gl.Enablei(GL_BLEND, 1), gl.Enablei(GL_BLEND, 3);
  gl.ColorMaski(2, GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE),
      gl.ColorMaski(0, GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl.ViewportIndexedf(3, 0.5f, 1.5f, 20.25f, 21), gl.ScissorIndexed(5, 1, 1, 9, 9),
      gl.DepthRangeIndexed(2, 0.1, 0.2);
  for (GLenum store :
       {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_IMAGE_HEIGHT,
        GL_UNPACK_SKIP_IMAGES, GL_PACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES, GL_UNPACK_LSB_FIRST})
    gl.PixelStorei(store, 1);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  GLuint buffer = 0, sampler = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.GenSamplers(1, &sampler);
  for (GLuint unit = 12; unit < 16; ++unit) gl.BindSampler(unit, sampler);
  for (GLenum unit = 10; unit < 16; ++unit) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.ActiveTexture(GL_TEXTURE0 + unit);
    gl.BindTexture(GL_TEXTURE_2D, texture);
  }
  gl.ActiveTexture(GL_TEXTURE3);
  if (core) {
    GLuint array = 0;
    gl.GenVertexArrays(1, &array);
    gl.BindVertexArray(array);
    gl.EnableVertexAttribArray(2);
    gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    return;
  }
  gl.PolygonMode(GL_FRONT, GL_LINE), gl.PolygonMode(GL_BACK, GL_POINT);
  for (GLenum cap :
       {GL_ALPHA_TEST, GL_FOG, GL_LIGHTING, GL_POLYGON_STIPPLE, GL_COLOR_SUM, GL_TEXTURE_2D, GL_NORMALIZE})
    gl.Enable(cap);
  gl.AlphaFunc(GL_LESS, 0.25f), gl.ShadeModel(GL_FLAT), gl.MatrixMode(GL_TEXTURE);
  gl.PixelTransferf(GL_RED_SCALE, 2), gl.PixelTransferf(GL_BLUE_BIAS, 0.5f),
      gl.PixelTransferi(GL_MAP_COLOR, GL_TRUE);
  gl.Color4f(0.1f, 0.2f, 0.3f, 0.4f), gl.Normal3f(1, 2, 3), gl.TexCoord4f(1, 2, 3, 4), gl.EdgeFlag(GL_FALSE);
  gl.EnableClientState(GL_NORMAL_ARRAY), gl.VertexPointer(3, GL_DOUBLE, 24, nullptr);
}

Image makeImage(int samples) {
  Image image;
  image.x = 7, image.y = 9;
  image.resize(20, 21, samples);
  image.color.assign(image.color.size(), 0xff123456u);
  image.depth.assign(image.depth.size(), 0.5f);
  return image;
}

class StateLeakTest : public testing::TestWithParam<ContextWish> {
 protected:
  void SetUp() override {
    context_ = OsmesaContext::create(GetParam());
    ASSERT_TRUE(context_);
    while (context_->real().GetError() != GL_NO_ERROR) continue;
  }
  /// States before and after the first write (which makes our objects), and after a second one.
  void expectNothingChanges(const Image& image) {
    const gl::RealGl& gl = context_->real();
    const gluray::test::GlState before = gluray::test::queryState(gl);
    EXPECT_GT(before.size(), 1000u) << "the table is suspiciously short";
    WriteBack writeBack(gl);
    PendingErrors pending;
    ASSERT_TRUE(writeBack.write(image, {}, pending));
    EXPECT_EQ(gluray::test::differences(before, gluray::test::queryState(gl)), std::vector<std::string>{});
    ASSERT_TRUE(writeBack.write(image, {GL_LESS}, pending));
    if (image.samples == 1) { ASSERT_TRUE(writeBack.write(image, {.over = GL_FRONT}, pending)); }
    EXPECT_EQ(gluray::test::differences(before, gluray::test::queryState(gl)), std::vector<std::string>{});
    RecordProperty("names", static_cast<int>(before.size()));
  }
  std::unique_ptr<OsmesaContext> context_;
};

TEST_P(StateLeakTest, DefaultState) { expectNothingChanges(makeImage(1)); }

TEST_P(StateLeakTest, UnusualState) {
  unusualState(context_->real(), GetParam().core);
  expectNothingChanges(makeImage(1));
}

TEST_P(StateLeakTest, UnusualStateWithSamples) {
  unusualState(context_->real(), GetParam().core);
  expectNothingChanges(makeImage(4));
}

TEST_P(StateLeakTest, ReadingTheWindow) {
  const gl::RealGl& gl = context_->real();
  gl.ClearColor(1, 0.5f, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT);
  unusualState(gl, GetParam().core);
  for (GLenum store :
       {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS, GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST})
    gl.PixelStorei(store, 1);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 8);
  GLuint buffer = 0, framebuffer = 0;
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  const Features features = readFeatures(gl);
  if (features.readFramebuffers)
    gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
  const gluray::test::GlState before = gluray::test::queryState(gl);
  gl.DepthFunc(GL_ONE);
  std::vector<uint32_t> pixels(64 * 64);
  bool read = false;
  EXPECT_EQ(readColors(gl, features, {64, 64}, GL_FRONT, pixels, read), GLenum{GL_INVALID_ENUM});
  EXPECT_TRUE(read);
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  for (const uint32_t pixel : pixels)
    ASSERT_TRUE((pixel & 0xffffff) == 0x007fff || (pixel & 0xffffff) == 0x0080ff) << pixel;
  EXPECT_EQ(gluray::test::differences(before, gluray::test::queryState(gl)), std::vector<std::string>{});
  EXPECT_EQ(readColors(gl, features, {64, 64}, GL_COLOR_ATTACHMENT0, pixels, read), GLenum{GL_NO_ERROR});
  EXPECT_FALSE(read) << "there is no such buffer";
  EXPECT_EQ(gl.GetError(), GLenum{GL_NO_ERROR});
  EXPECT_EQ(gluray::test::differences(before, gluray::test::queryState(gl)), std::vector<std::string>{});
}

TEST_P(StateLeakTest, TheTableSeesAChange) {
  const gl::RealGl& gl = context_->real();
  const auto before = gluray::test::queryState(gl);
  gl.DepthFunc(GL_ALWAYS);
  gl.ActiveTexture(GL_TEXTURE15);
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.ColorMaski(3, GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
  EXPECT_GE(gluray::test::differences(before, gluray::test::queryState(gl)).size(), 3u);
}

TEST_P(StateLeakTest, ProgramAndFramebufferStayBound) {
  const gl::RealGl& gl = context_->real();
  const char* source = "void main() { gl_Position = vec4(0.0); }";
  const std::string text = std::string(GetParam().core ? "#version 150\n" : "#version 110\n") + source;
  const char* lines = text.c_str();
  const GLuint shader = gl.CreateShader(GL_VERTEX_SHADER), program = gl.CreateProgram();
  gl.ShaderSource(shader, 1, &lines, nullptr);
  gl.CompileShader(shader);
  gl.AttachShader(program, shader);
  gl.LinkProgram(program);
  gl.UseProgram(program);
  GLint current = 0;
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &current);
  ASSERT_EQ(current, static_cast<GLint>(program));
  expectNothingChanges(makeImage(1));
}

std::string nameOf(const testing::TestParamInfo<ContextWish>& info) {
  const ContextWish& w = info.param;
  return std::string(w.core ? "core" : "compat") + std::to_string(w.major) + std::to_string(w.minor);
}

/// Reading all state takes seconds under sanitizers: there, one context of each profile.
std::vector<ContextWish> contexts() {
  const ContextWish newest{64, 64, true, 4, 5}, oldest{64, 64, false, 0, 0};
  if (kSanitized) return {oldest, newest};
  return {oldest, {64, 64, false, 2, 1}, {64, 64, true, 3, 2}, newest};
}

INSTANTIATE_TEST_SUITE_P(Contexts, StateLeakTest, testing::ValuesIn(contexts()), nameOf);

}  // namespace
}  // namespace gluray::present
