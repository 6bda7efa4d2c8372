// Uploads of pictures into the textures of a framebuffer object: only if it is known to hold just its clear
// values, and with the same result, bit by bit, as a drawn picture.
#include "settings/quirks.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
constexpr int kSize = 64;  // pixels of the textures, and of the window

struct Canvas {
  GLuint framebuffer = 0, color = 0, depth = 0;
};

GLuint texture(Gl gl, GLenum internalFormat, GLenum format, GLenum type) {
  GLuint name = 0;
  gl.GenTextures(1, &name), gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), kSize, kSize, 0, format, type, nullptr);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return name;
}

Canvas makeCanvas(Gl gl) {
  Canvas c;
  c.color = texture(gl, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
  c.depth = texture(gl, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8);
  gl.GenFramebuffers(1, &c.framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, c.framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, c.color, 0);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, c.depth, 0);
  return c;
}

void clear(Gl gl) {
  gl.ClearColor(0.1f, 0.33f, 0.77f, 0.25f);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

/// A wavy sheet, seen from above, with gaps around it.
void sheet(Gl gl, float lift = 0) {
  gl.Begin(GL_TRIANGLES);
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 20; ++k) {
      const auto at = [&](int x, int y) {
        const float u = 0.08f * static_cast<float>(x) - 0.8f, v = 0.08f * static_cast<float>(y) - 0.8f;
        gl.Color4f(0.5f + 0.5f * u, 0.5f + 0.5f * v, 0.3f, 1);
        gl.Vertex3f(u, v, 0.4f * std::sin(4 * u + 3 * v) + lift);
      };
      at(i, k), at(i + 1, k), at(i + 1, k + 1);
      at(i, k), at(i + 1, k + 1), at(i, k + 1);
    }
  gl.End();
}

void line(Gl gl) {
  gl.Begin(GL_LINES);
  gl.Color3f(1, 1, 1), gl.Vertex3f(-1, -0.9f, 0.9f), gl.Vertex3f(1, 0.8f, -0.9f);
  gl.End();
}

struct Case {
  const char* name;
  int sent;  // expected number of uploaded pictures
  void (*frame)(Gl gl, const Canvas& canvas) = [](Gl gl, const Canvas&) { clear(gl), sheet(gl); };
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

const Case kCases[] = {
    {"Plain", 1},
    {"TwoFrames", 2, [](Gl gl, const Canvas&) { clear(gl), sheet(gl), clear(gl), sheet(gl, 0.1f); }},
    {"ClearColorOfLater", 1,
     [](Gl gl, const Canvas&) { clear(gl), gl.ClearColor(1, 0, 0, 1), gl.ClearDepth(0.2), sheet(gl); }},
    {"InAList", 1,
     [](Gl gl, const Canvas&) {
       const GLuint list = gl.GenLists(1);
       gl.NewList(list, GL_COMPILE), clear(gl), sheet(gl), gl.EndList();
       gl.CallList(list);
     }},
    {"ScissorAround", 1,
     [](Gl gl, const Canvas&) {
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, kSize, kSize);
       clear(gl), sheet(gl);
     }},
    {"PartOfTheTexture", 1,
     [](Gl gl, const Canvas&) {
       clear(gl), gl.Viewport(10, 20, 40, 30), sheet(gl), gl.Viewport(0, 0, kSize, kSize);
     }},
    {"LinesAfterwards", 1, [](Gl gl, const Canvas&) { clear(gl), sheet(gl), line(gl); }},
    {"SecondPicture", 1,
     [](Gl gl, const Canvas&) {
       clear(gl), sheet(gl);
       GLuint pixel = 0;
       gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
       sheet(gl, 0.2f);
     }},
    {"LinesBefore", 0, [](Gl gl, const Canvas&) { clear(gl), line(gl), sheet(gl); }},
    {"BlendedBefore", 0,
     [](Gl gl, const Canvas&) {
       clear(gl);
       gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), sheet(gl, 0.3f), gl.Disable(GL_BLEND);
       sheet(gl);
     }},
    {"ListOfTheRealOneBefore", 0,
     [](Gl gl, const Canvas&) {
       const GLuint list = gl.GenLists(1), bits = 0xFFFFFFFF;
       gl.NewList(list, GL_COMPILE);
       gl.WindowPos2i(20, 20), gl.Bitmap(32, 1, 0, 0, 0, 0, reinterpret_cast<const GLubyte*>(&bits));
       gl.EndList();
       clear(gl), gl.CallList(list), sheet(gl);
     }},
    {"PixelsBefore", 0,
     [](Gl gl, const Canvas&) {
       const std::vector<GLuint> red(100, 0xFF0000FF);
       clear(gl), gl.WindowPos2i(5, 50), gl.DrawPixels(10, 10, GL_RGBA, GL_UNSIGNED_BYTE, red.data()),
           sheet(gl);
     }},
    {"UploadBefore", 0,
     [](Gl gl, const Canvas& c) {
       const std::vector<GLuint> red(100, 0xFF0000FF);
       clear(gl);
       gl.BindTexture(GL_TEXTURE_2D, c.color);
       gl.TexSubImage2D(GL_TEXTURE_2D, 0, 2, 50, 10, 10, GL_RGBA, GL_UNSIGNED_BYTE, red.data());
       gl.BindTexture(GL_TEXTURE_2D, 0);
       sheet(gl);
     }},
    {"BlitBefore", 0,
     [](Gl gl, const Canvas& c) {
       gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, c.framebuffer);
       clear(gl);
       gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
       gl.BlitFramebuffer(0, 0, 20, 20, 40, 40, 60, 60, GL_COLOR_BUFFER_BIT, GL_NEAREST);
       gl.BindFramebuffer(GL_READ_FRAMEBUFFER, c.framebuffer);
       sheet(gl);
     }},
    {"PartClearedAgain", 0,
     [](Gl gl, const Canvas&) {
       clear(gl);
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(30, 30, 30, 30);
       gl.ClearColor(1, 0, 0, 1), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
       gl.Disable(GL_SCISSOR_TEST);
       sheet(gl);
     }},
    {"DepthAlone", 1,
     [](Gl gl, const Canvas&) {
       clear(gl), sheet(gl), gl.Clear(GL_DEPTH_BUFFER_BIT), sheet(gl, 0.2f), gl.Finish();
     }},
    {"MaskedColors", 0,
     [](Gl gl, const Canvas&) {
       gl.ColorMask(1, 0, 1, 1), clear(gl), gl.ColorMask(1, 1, 1, 1);
       sheet(gl);
     }},
    {"MaskedDepth", 0,
     [](Gl gl, const Canvas&) {
       gl.ClearDepth(0.45), clear(gl), gl.ClearDepth(1);
       gl.DepthMask(GL_FALSE), clear(gl), gl.DepthMask(GL_TRUE);
       sheet(gl);
     }},
    {"NearerDepth", 0,
     [](Gl gl, const Canvas&) { gl.ClearDepth(0.5), clear(gl), sheet(gl), gl.ClearDepth(1); }},
    {"Less", 0,
     [](Gl gl, const Canvas&) { gl.DepthFunc(GL_LESS), clear(gl), sheet(gl), gl.DepthFunc(GL_LEQUAL); }},
    {"StencilValues", 0,
     [](Gl gl, const Canvas& c) {
       gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_TEXTURE_2D, c.depth, 0);
       gl.ClearStencil(5), gl.Clear(GL_STENCIL_BUFFER_BIT);
       clear(gl), sheet(gl);
     }},
    {"AnotherFramebufferBetween", 0,
     [](Gl gl, const Canvas& c) {
       clear(gl);
       gl.BindFramebuffer(GL_FRAMEBUFFER, 0), line(gl), gl.BindFramebuffer(GL_FRAMEBUFFER, c.framebuffer);
       sheet(gl);
     }},
    {"Discarded", 0,
     [](Gl gl, const Canvas&) {
       clear(gl), line(gl);
       gl.Enable(GL_RASTERIZER_DISCARD), clear(gl), gl.Disable(GL_RASTERIZER_DISCARD);
       sheet(gl);
     }},
    {"Renderbuffer", 0,
     [](Gl gl, const Canvas&) {
       GLuint name = 0;
       gl.GenRenderbuffers(1, &name), gl.BindRenderbuffer(GL_RENDERBUFFER, name);
       gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kSize, kSize);
       gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, name);
       clear(gl), sheet(gl);
     }},
    {"Window", 0,
     [](Gl gl, const Canvas& c) {
       gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
       clear(gl), sheet(gl), gl.Finish();
       gl.BindFramebuffer(GL_FRAMEBUFFER, c.framebuffer);
       line(gl);
     }},
};

struct Result {
  std::vector<uint32_t> color, depth;
  GLenum error = GL_NO_ERROR;
  uint64_t sent = 0;
};

Result run(const Case& c, bool on) {
  Settings settings = TracedContext::vertexShading();
  EXPECT_EQ(readQuirks(on ? "software-put=on" : "software-put=off", settings.quirks), "");
  const TracedContext traced({}, settings);
  Gl gl = traced.gl();
  gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LEQUAL), gl.Viewport(0, 0, kSize, kSize);
  const Canvas canvas = makeCanvas(gl);
  const uint64_t before = useCount(Quirk::softwarePut);
  c.frame(gl, canvas);
  Result r{std::vector<uint32_t>(kSize * kSize), std::vector<uint32_t>(kSize * kSize)};
  gl.ReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, r.color.data());
  gl.ReadPixels(0, 0, kSize, kSize, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, r.depth.data());
  r.error = gl.GetError();
  r.sent = useCount(Quirk::softwarePut) - before;
  EXPECT_GT(uint64_t{traced.context().counts.statistics.drawsTraced}, 0u) << "nothing was traced";
  return r;
}

class TextureUploads : public testing::TestWithParam<Case> {};

TEST_P(TextureUploads, EqualDrawnPictures) {
  const Result off = run(GetParam(), false), on = run(GetParam(), true);
  EXPECT_EQ(off.sent, 0u);
  EXPECT_EQ(on.sent, static_cast<uint64_t>(GetParam().sent));
  EXPECT_EQ(on.color, off.color);
  EXPECT_EQ(on.depth, off.depth);
  EXPECT_EQ(on.error, off.error);
}

INSTANTIATE_TEST_SUITE_P(All, TextureUploads, testing::ValuesIn(kCases),
                         [](const auto& info) { return info.param.name; });

/// Another context of the group draws into the texture between the clear and the picture.
TEST(TextureUploads, NoticeDrawsOfOtherContexts) {
  TracedContext one;
  const TracedContext other({}, TracedContext::vertexShading(), nullptr, &one);
  one.makeCurrent();
  Gl gl = one.gl();
  gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LEQUAL);
  const Canvas canvas = makeCanvas(gl);
  clear(gl);
  const_cast<TracedContext&>(other).makeCurrent();
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, canvas.color, 0);
  gl.ClearColor(1, 0, 0, 1), gl.Clear(GL_COLOR_BUFFER_BIT), gl.Finish();
  one.makeCurrent();
  const uint64_t before = useCount(Quirk::softwarePut);
  sheet(gl);
  GLuint corner = 0;
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &corner);
  EXPECT_EQ(corner, 0xFF0000FFu);
  EXPECT_EQ(useCount(Quirk::softwarePut), before);
}

}  // namespace
}  // namespace gluray::test
