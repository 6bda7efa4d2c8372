// Anti-aliasing passes are left out exactly over images that --spp has anti-aliased. GLuRay takes the pass
// of this test for VTK's, but it inverts colours, which shows where it was not left out.
#include "scenes/stage.h"
#include "settings/quirks.h"
#include "tests/reference/programs/program_stage.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <functional>
#include <ostream>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
constexpr int kAveragedSize = 64;  // pixels of the textures, and of the window

constexpr const char* kWholeWindowVertex =
    "#version 130\nin vec4 ndCoordIn; in vec2 texCoordIn; out vec2 tc;\n"
    "void main() { gl_Position = ndCoordIn; tc = texCoordIn; }\n";
constexpr const char* kInvert =
    "#version 130\n#define FXAA_USE_HIGH_QUALITY_ENDPOINTS\n"
    "in vec2 tc; uniform sampler2D Input; uniform vec2 InvTexSize; uniform int EndpointSearchIterations;\n"
    "void main() {\n  if (EndpointSearchIterations < 0 || InvTexSize.x < 0.0) discard;\n"
    "  gl_FragColor = vec4(1.0 - texture2D(Input, tc).rgb, 1.0);\n}\n";

struct Box {
  int x = 0, y = 0, width = kAveragedSize, height = kAveragedSize;
};

/// A program with a framebuffer object, and a texture that images are copied to for the pass.
class AveragedProgram {
 public:
  explicit AveragedProgram(Gl g) : gl(g), pass_(makeProgram(g, kWholeWindowVertex, kInvert)) {
    color = makeTexture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, kAveragedSize, kAveragedSize);
    const GLuint depth = makeTexture(GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                                     kAveragedSize, kAveragedSize);
    gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    constexpr float kStrip[] = {-1, -1, 0, 1, 1, -1, 0, 1, -1, 1, 0, 1, 1, 1, 0, 1,  //
                                0,  0,  1, 0, 0, 1,  1, 1};
    gl.GenBuffers(1, &buffer_), gl.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl.BufferData(GL_ARRAY_BUFFER, sizeof kStrip, kStrip, GL_STATIC_DRAW);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0);
    gl.ClearColor(0.1f, 0.2f, 0.3f, 1), gl.DepthFunc(GL_LEQUAL);
  }

  GLuint makeTexture(GLenum internalFormat, GLenum format, GLenum type, int width, int height) {
    GLuint name = 0;
    gl.GenTextures(1, &name), gl.BindTexture(GL_TEXTURE_2D, name);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      gl.TexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
      gl.TexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internalFormat), width, height, 0, format, type,
                  nullptr);
    gl.BindTexture(GL_TEXTURE_2D, 0);
    return name;
  }

  void clear() { gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT); }
  void surface(float shift = 0) {
    gl.Enable(GL_DEPTH_TEST);
    gl.Begin(GL_TRIANGLES);
    gl.Color3f(1, 0.6f, 0.2f);
    gl.Vertex3f(-0.7f + shift, -0.6f, 0.3f), gl.Vertex3f(0.5f + shift, -0.4f, -0.2f),
        gl.Vertex3f(shift, 0.7f, shift);
    gl.End();
  }
  void line() {
    gl.Begin(GL_LINES);
    gl.Vertex3f(-0.9f, -0.8f, -0.5f), gl.Vertex3f(0.9f, 0.7f, -0.5f);
    gl.End();
  }
  /// Copies the image, or a part, into the texture that the pass reads.
  void copy(Box from = {}) {
    if (input_ == 0 || from.width != kAveragedSize)
      input_ = makeTexture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, from.width, from.height);
    gl.BindTexture(GL_TEXTURE_2D, input_);
    gl.CopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, from.x, from.y, from.width, from.height);
  }
  void pass(Box to = {}) {
    gl.Viewport(to.x, to.y, to.width, to.height), gl.Disable(GL_DEPTH_TEST), gl.DepthMask(GL_FALSE);
    gl.UseProgram(pass_);
    setInteger(gl, pass_, "EndpointSearchIterations", 12);
    gl.Uniform2f(gl.GetUniformLocation(pass_, "InvTexSize"), texel, texel);
    const auto array = [&](const char* name, int size, size_t offset) {
      const auto at = static_cast<GLuint>(gl.GetAttribLocation(pass_, name));
      gl.BindBuffer(GL_ARRAY_BUFFER, buffer_), gl.EnableVertexAttribArray(at);
      gl.VertexAttribPointer(at, size, GL_FLOAT, GL_FALSE, 0, reinterpret_cast<const void*>(offset));
      return at;
    };
    const GLuint position = array("ndCoordIn", 4, 0), texcoord = array("texCoordIn", 2, 64);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl.DisableVertexAttribArray(position), gl.DisableVertexAttribArray(texcoord);
    gl.BindBuffer(GL_ARRAY_BUFFER, 0), gl.UseProgram(0);
    gl.DepthMask(GL_TRUE), gl.Viewport(0, 0, kAveragedSize, kAveragedSize);
  }

  Gl gl;
  GLuint framebuffer = 0, color = 0;
  float texel = 1.0f / kAveragedSize;  // of passes

 private:
  GLuint pass_, buffer_ = 0, input_ = 0;
};

enum class Kept { none, all };  // how many of the passes are drawn
struct AveragedCase {
  const char* name;
  Kept passes;
  std::function<void(AveragedProgram&)> frame;
  bool on = true;
  int spp = 4;
  bool computed = false;  // passes over other images are computed, too
};
void PrintTo(const AveragedCase& c, std::ostream* out) { *out << c.name; }

void plainFrame(AveragedProgram& p) { p.clear(), p.surface(), p.copy(), p.pass(); }

const AveragedCase kAveragedCases[] = {
    {"Plain", Kept::none, plainFrame},
    {"OneRayAPixel", Kept::all, plainFrame, true, 1},
    {"SwitchedOff", Kept::all, plainFrame, false},
    {"NothingDrawn", Kept::none, [](AveragedProgram& p) { p.clear(), p.copy(), p.pass(); }},
    {"NeverCleared", Kept::all, [](AveragedProgram& p) { p.surface(), p.copy(), p.pass(); }},
    {"TwoImages", Kept::none,
     [](AveragedProgram& p) { p.clear(), p.surface(), p.gl.Flush(), p.surface(0.3f), p.copy(), p.pass(); }},
    {"AFrameAfterAnother", Kept::none, [](AveragedProgram& p) { plainFrame(p), plainFrame(p); }},
    {"PixelsReadBefore", Kept::none,
     [](AveragedProgram& p) {
       uint32_t pixel = 0;
       p.clear(), p.surface();
       p.gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
       p.copy(), p.pass();
     }},
    {"ALineBefore", Kept::all,
     [](AveragedProgram& p) { p.clear(), p.surface(), p.line(), p.copy(), p.pass(); }},
    {"ALineUnderIt", Kept::all,
     [](AveragedProgram& p) { p.clear(), p.line(), p.surface(), p.copy(), p.pass(); }},
    {"PixelsSentBefore", Kept::all,
     [](AveragedProgram& p) {
       constexpr uint32_t kPixel = 0xff00ff00;
       p.clear(), p.surface();
       p.gl.RasterPos2f(0, 0), p.gl.DrawPixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &kPixel);
       p.copy(), p.pass();
     }},
    {"ASurfaceAfterTheCopy", Kept::all,
     [](AveragedProgram& p) { p.clear(), p.surface(), p.copy(), p.surface(0.3f), p.pass(); }},
    {"AClearAfterTheCopy", Kept::all,
     [](AveragedProgram& p) { p.clear(), p.surface(), p.copy(), p.clear(), p.pass(); }},
    {"TexelsSentAfterTheCopy", Kept::all,
     [](AveragedProgram& p) {
       constexpr uint32_t kPixel = 0xff00ff00;
       p.clear(), p.surface(), p.copy();
       p.gl.TexSubImage2D(GL_TEXTURE_2D, 0, 3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &kPixel);
       p.pass();
     }},
    {"ClearedInPart", Kept::all,
     [](AveragedProgram& p) {
       p.gl.Enable(GL_SCISSOR_TEST), p.gl.Scissor(0, 0, kAveragedSize / 2, kAveragedSize);
       p.clear();
       p.gl.Disable(GL_SCISSOR_TEST);
       p.surface(), p.copy(), p.pass();
     }},
    {"ThePartThatWasCleared", Kept::none,
     [](AveragedProgram& p) {
       const Box part{8, 0, 40, kAveragedSize};
       p.gl.Enable(GL_SCISSOR_TEST), p.gl.Scissor(0, 0, 56, kAveragedSize);
       p.clear();
       p.surface();
       p.gl.Disable(GL_SCISSOR_TEST);
       p.copy(part), p.pass(part);
     }},
    {"ClearedAgainInPart", Kept::none,
     [](AveragedProgram& p) {
       p.clear();
       p.gl.Enable(GL_SCISSOR_TEST), p.gl.Scissor(5, 5, 9, 9);
       p.clear();
       p.gl.Disable(GL_SCISSOR_TEST);
       p.surface(), p.copy(), p.pass();
     }},
    {"OverAnotherPart", Kept::all,
     [](AveragedProgram& p) {
       p.clear(), p.surface(), p.copy({0, 0, 40, kAveragedSize}), p.pass({8, 0, 40, kAveragedSize});
     }},
    {"ColorsMasked", Kept::all,
     [](AveragedProgram& p) {
       p.gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
       p.clear();
       p.gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
       p.surface(), p.copy(), p.pass();
     }},
    {"IntoAnotherFramebuffer", Kept::all,
     [](AveragedProgram& p) {
       p.clear(), p.surface(), p.copy();
       AveragedProgram other(p.gl);  // binds its own
       p.pass();
       p.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, other.framebuffer);
     }},
};

class SmoothTest : public testing::TestWithParam<AveragedCase> {};

/// The frame's image, with the case's samples a pixel and quirk setting.
std::pair<DrawnImage, uint64_t> play(const std::function<void(AveragedProgram&)>& frame,
                                     const AveragedCase& c) {
  Settings settings = TracedContext::vertexShading();
  settings.spp = c.spp;
  settings.quirks.set("spp-fxaa", c.on);
  settings.quirks.set("software-fxaa", c.computed);
  TracedContext context({kAveragedSize, kAveragedSize}, settings);
  AveragedProgram program(context.gl());
  frame(program);
  DrawnImage image = readImage(context.gl(), kAveragedSize, kAveragedSize);
  EXPECT_EQ(context.gl().GetError(), GLenum{GL_NO_ERROR});
  return {std::move(image), context.context().counts.statistics.drawsRasterised};
}

TEST_P(SmoothTest, ThePassIsLeftOutWhereItChangesNothing) {
  const AveragedCase& c = GetParam();
  AveragedCase off = c;
  off.on = false;
  const auto [image, draws] = play(c.frame, c);
  const auto [drawn, allDraws] = play(c.frame, off);
  if (c.passes == Kept::all) {
    EXPECT_EQ(image.colors, drawn.colors);
    EXPECT_EQ(draws, allDraws);
  } else {
    EXPECT_NE(image.colors, drawn.colors);
    EXPECT_LT(draws, allDraws);
  }
  EXPECT_EQ(image.depths, drawn.depths);
}

TEST(Smooth, AImageWithoutThePassIsKept) {
  const AveragedCase c{"", Kept::none, plainFrame};
  EXPECT_EQ(play(plainFrame, c).first.colors,
            play([](AveragedProgram& p) { p.clear(), p.surface(); }, c).first.colors);
}

TEST(Smooth, PassesWithOtherTexelsAreNotComputed) {
  AveragedCase drawn{"", Kept::all, plainFrame, false, 1};
  AveragedCase computed = drawn;
  computed.computed = true;
  EXPECT_NE(play(plainFrame, computed).first.colors, play(plainFrame, drawn).first.colors);
  const auto wide = [](AveragedProgram& p) { p.texel *= 2, plainFrame(p); };
  EXPECT_EQ(play(wide, computed).first.colors, play(wide, drawn).first.colors);
}

INSTANTIATE_TEST_SUITE_P(Cases, SmoothTest, testing::ValuesIn(kAveragedCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
