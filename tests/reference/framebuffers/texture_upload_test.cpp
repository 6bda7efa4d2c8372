// Uploads of images into the textures of a framebuffer object: only if it is known to hold just its clear
// values, and with the same result, bit by bit, as a drawn image.
#include "settings/quirks.h"
#include "tests/reference/framebuffers/texture_upload_stage.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <ostream>
#include <vector>

namespace gluray::test {
namespace {

using namespace texture_upload;

/// Deletes the texture, which lives on in the framebuffer that is not bound, and gives its name to another
/// one.
void reuseName(Gl gl, const Canvas& c, GLuint texture) {
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  gl.DeleteTextures(1, &texture), gl.BindTexture(GL_TEXTURE_2D, texture);
  if (texture == c.color)
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kUploadSize, kUploadSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                  nullptr);
  else
    gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH24_STENCIL8, kUploadSize, kUploadSize, 0, GL_DEPTH_STENCIL,
                  GL_UNSIGNED_INT_24_8, nullptr);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST), gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.BindFramebuffer(GL_FRAMEBUFFER, c.framebuffer);
}

struct UploadCase {
  const char* name;
  int sent;  // expected number of uploaded images
  void (*frame)(Gl gl, const Canvas& canvas) = [](Gl gl, const Canvas&) { clear(gl), flatSheet(gl); };
};
void PrintTo(const UploadCase& c, std::ostream* out) { *out << c.name; }

const UploadCase kUploadCases[] = {
    {"Plain", 1},
    {"TwoFrames", 2, [](Gl gl, const Canvas&) { clear(gl), flatSheet(gl), clear(gl), flatSheet(gl, 0.1f); }},
    {"LinesInTheSecondFrame", 1,
     [](Gl gl, const Canvas&) {
       clear(gl), flatSheet(gl), clear(gl), crossingLine(gl), flatSheet(gl, 0.1f);
     }},
    {"ClearColorOfLater", 1,
     [](Gl gl, const Canvas&) { clear(gl), gl.ClearColor(1, 0, 0, 1), gl.ClearDepth(0.2), flatSheet(gl); }},
    {"InAList", 1,
     [](Gl gl, const Canvas&) {
       const GLuint list = gl.GenLists(1);
       gl.NewList(list, GL_COMPILE), clear(gl), flatSheet(gl), gl.EndList();
       gl.CallList(list);
     }},
    {"ScissorAround", 1,
     [](Gl gl, const Canvas&) {
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, kUploadSize, kUploadSize);
       clear(gl), flatSheet(gl);
     }},
    {"ScissorBeyond", 1,
     [](Gl gl, const Canvas&) {
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(-1, -1, kUploadSize + 2, kUploadSize + 2);
       clear(gl), flatSheet(gl);
     }},
    {"OtherFormatBefore", 1,
     [](Gl gl, const Canvas& c) {
       Canvas opaque = c;
       opaque.color = uploadTarget(gl, GL_RGB8, GL_RGB, GL_UNSIGNED_BYTE);
       attach(gl, opaque);
       GLuint pixel = 0;
       clear(gl), flatSheet(gl), gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
       gl.BindFramebuffer(GL_FRAMEBUFFER, c.framebuffer);
       clear(gl), flatSheet(gl);
     }},
    {"MipmapsOfUploads", 0,  // which draws do not make
     [](Gl gl, const Canvas& c) {
       gl.BindTexture(GL_TEXTURE_2D, c.color);
       gl.TexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE), gl.BindTexture(GL_TEXTURE_2D, 0);
       clear(gl), flatSheet(gl);
     }},
    {"DrawBufferPopped", 0,
     [](Gl gl, const Canvas&) {
       const GLuint other = uploadTarget(gl, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
       gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, other, 0);
       gl.DrawBuffer(GL_COLOR_ATTACHMENT1), gl.ClearColor(1, 0, 0, 1), gl.Clear(GL_COLOR_BUFFER_BIT);
       gl.PushAttrib(GL_COLOR_BUFFER_BIT), gl.DrawBuffer(GL_COLOR_ATTACHMENT0), clear(gl), gl.PopAttrib();
       flatSheet(gl), gl.ReadBuffer(GL_COLOR_ATTACHMENT1);
     }},
    {"PartOfTheTexture", 1,
     [](Gl gl, const Canvas&) {
       clear(gl), gl.Viewport(10, 20, 40, 30), flatSheet(gl), gl.Viewport(0, 0, kUploadSize, kUploadSize);
     }},
    {"LinesAfterwards", 1, [](Gl gl, const Canvas&) { clear(gl), flatSheet(gl), crossingLine(gl); }},
    {"SecondImage", 1,
     [](Gl gl, const Canvas&) {
       clear(gl), flatSheet(gl);
       GLuint pixel = 0;
       gl.ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &pixel);
       flatSheet(gl, 0.2f);
     }},
    {"DeletedColorTexture", 0,
     [](Gl gl, const Canvas& c) { reuseName(gl, c, c.color), clear(gl), flatSheet(gl); }},
    {"DeletedDepthTexture", 0,
     [](Gl gl, const Canvas& c) { reuseName(gl, c, c.depth), clear(gl), flatSheet(gl); }},
    {"TexturesOfDeletedNames", 1,
     [](Gl gl, const Canvas& c) {
       Canvas again = c;
       reuseName(gl, c, c.color), reuseName(gl, c, c.depth), attach(gl, again), clear(gl), flatSheet(gl);
     }},
    {"LinesBefore", 0, [](Gl gl, const Canvas&) { clear(gl), crossingLine(gl), flatSheet(gl); }},
    {"BlendedBefore", 0,
     [](Gl gl, const Canvas&) {
       clear(gl);
       gl.Enable(GL_BLEND), gl.BlendFunc(GL_ONE, GL_ONE), flatSheet(gl, 0.3f), gl.Disable(GL_BLEND);
       flatSheet(gl);
     }},
    {"ListOfTheRealOneBefore", 0,
     [](Gl gl, const Canvas&) {
       const GLuint list = gl.GenLists(1), bits = 0xFFFFFFFF;
       gl.NewList(list, GL_COMPILE);
       gl.WindowPos2i(20, 20), gl.Bitmap(32, 1, 0, 0, 0, 0, reinterpret_cast<const GLubyte*>(&bits));
       gl.EndList();
       clear(gl), gl.CallList(list), flatSheet(gl);
     }},
    {"PixelsBefore", 0,
     [](Gl gl, const Canvas&) {
       const std::vector<GLuint> red(100, 0xFF0000FF);
       clear(gl), gl.WindowPos2i(5, 50), gl.DrawPixels(10, 10, GL_RGBA, GL_UNSIGNED_BYTE, red.data()),
           flatSheet(gl);
     }},
    {"UploadBefore", 0,
     [](Gl gl, const Canvas& c) {
       const std::vector<GLuint> red(100, 0xFF0000FF);
       clear(gl);
       gl.BindTexture(GL_TEXTURE_2D, c.color);
       gl.TexSubImage2D(GL_TEXTURE_2D, 0, 2, 50, 10, 10, GL_RGBA, GL_UNSIGNED_BYTE, red.data());
       gl.BindTexture(GL_TEXTURE_2D, 0);
       flatSheet(gl);
     }},
    {"BlitBefore", 0,
     [](Gl gl, const Canvas& c) {
       gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, c.framebuffer);
       clear(gl);
       gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
       gl.BlitFramebuffer(0, 0, 20, 20, 40, 40, 60, 60, GL_COLOR_BUFFER_BIT, GL_NEAREST);
       gl.BindFramebuffer(GL_READ_FRAMEBUFFER, c.framebuffer);
       flatSheet(gl);
     }},
    {"PartClearedAgain", 0,
     [](Gl gl, const Canvas&) {
       clear(gl);
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(30, 30, 30, 30);
       gl.ClearColor(1, 0, 0, 1), gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
       gl.Disable(GL_SCISSOR_TEST);
       flatSheet(gl);
     }},
    {"DepthAlone", 1,
     [](Gl gl, const Canvas&) {
       clear(gl), flatSheet(gl), gl.Clear(GL_DEPTH_BUFFER_BIT), flatSheet(gl, 0.2f), gl.Finish();
     }},
    {"MaskedColors", 0,
     [](Gl gl, const Canvas&) {
       gl.ColorMask(1, 0, 1, 1), clear(gl), gl.ColorMask(1, 1, 1, 1);
       flatSheet(gl);
     }},
    {"MaskedDepth", 0,
     [](Gl gl, const Canvas&) {
       gl.ClearDepth(0.45), clear(gl), gl.ClearDepth(1);
       gl.DepthMask(GL_FALSE), clear(gl), gl.DepthMask(GL_TRUE);
       flatSheet(gl);
     }},
    {"NearerDepth", 0,
     [](Gl gl, const Canvas&) { gl.ClearDepth(0.5), clear(gl), flatSheet(gl), gl.ClearDepth(1); }},
    {"Less", 0,
     [](Gl gl, const Canvas&) { gl.DepthFunc(GL_LESS), clear(gl), flatSheet(gl), gl.DepthFunc(GL_LEQUAL); }},
    {"StencilValues", 0,
     [](Gl gl, const Canvas& c) {
       gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_TEXTURE_2D, c.depth, 0);
       gl.ClearStencil(5), gl.Clear(GL_STENCIL_BUFFER_BIT);
       clear(gl), flatSheet(gl);
     }},
    {"AnotherFramebufferBetween", 0,
     [](Gl gl, const Canvas& c) {
       clear(gl);
       gl.BindFramebuffer(GL_FRAMEBUFFER, 0), crossingLine(gl),
           gl.BindFramebuffer(GL_FRAMEBUFFER, c.framebuffer);
       flatSheet(gl);
     }},
    {"Discarded", 0,
     [](Gl gl, const Canvas&) {
       clear(gl), crossingLine(gl);
       gl.Enable(GL_RASTERIZER_DISCARD), clear(gl), gl.Disable(GL_RASTERIZER_DISCARD);
       flatSheet(gl);
     }},
    {"Renderbuffer", 0,
     [](Gl gl, const Canvas&) {
       GLuint name = 0;
       gl.GenRenderbuffers(1, &name), gl.BindRenderbuffer(GL_RENDERBUFFER, name);
       gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kUploadSize, kUploadSize);
       gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, name);
       clear(gl), flatSheet(gl);
     }},
    {"Window", 0,
     [](Gl gl, const Canvas& c) {
       gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
       clear(gl), flatSheet(gl), gl.Finish();
       gl.BindFramebuffer(GL_FRAMEBUFFER, c.framebuffer);
       crossingLine(gl);
     }},
};

struct UploadResult {
  std::vector<uint32_t> color, depth;
  GLenum error = GL_NO_ERROR;
  uint64_t sent = 0;
};

UploadResult runUpload(const UploadCase& c, bool on) {
  Settings settings = TracedContext::vertexShading();
  EXPECT_EQ(readQuirks(on ? "software-put=on" : "software-put=off", settings.quirks), "");
  const TracedContext traced({}, settings);
  Gl gl = traced.gl();
  gl.Enable(GL_DEPTH_TEST), gl.DepthFunc(GL_LEQUAL), gl.Viewport(0, 0, kUploadSize, kUploadSize);
  const Canvas canvas = makeCanvas(gl);
  const uint64_t before = useCount(Quirk::softwarePut);
  c.frame(gl, canvas);
  UploadResult r{std::vector<uint32_t>(kUploadSize * kUploadSize),
                 std::vector<uint32_t>(kUploadSize * kUploadSize)};
  gl.ReadPixels(0, 0, kUploadSize, kUploadSize, GL_RGBA, GL_UNSIGNED_BYTE, r.color.data());
  gl.ReadPixels(0, 0, kUploadSize, kUploadSize, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, r.depth.data());
  r.error = gl.GetError();
  r.sent = useCount(Quirk::softwarePut) - before;
  EXPECT_GT(uint64_t{traced.context().counts.statistics.drawsTraced}, 0u) << "nothing was traced";
  return r;
}

class TextureUploads : public testing::TestWithParam<UploadCase> {};

TEST_P(TextureUploads, EqualDrawnImages) {
  const UploadResult off = runUpload(GetParam(), false), on = runUpload(GetParam(), true);
  EXPECT_EQ(off.sent, 0u);
  EXPECT_EQ(on.sent, static_cast<uint64_t>(GetParam().sent));
  EXPECT_EQ(on.color, off.color);
  EXPECT_EQ(on.depth, off.depth);
  EXPECT_EQ(on.error, off.error);
}

INSTANTIATE_TEST_SUITE_P(All, TextureUploads, testing::ValuesIn(kUploadCases),
                         [](const auto& info) { return info.param.name; });

/// Another context of the group draws into the texture between the clear and the image.
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
  flatSheet(gl);
  GLuint corner = 0;
  gl.ReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, &corner);
  EXPECT_EQ(corner, 0xFF0000FFu);
  EXPECT_EQ(useCount(Quirk::softwarePut), before);
}

/// A fence comes after the image only where another context may wait for it.
TEST(TextureUploads, ComeBeforeFencesOfSharedTextures) {
  const auto drawThenFence = [](Gl gl) {
    const GLuint texture = makeCanvas(gl).color;
    gl.Enable(GL_DEPTH_TEST), clear(gl), flatSheet(gl);
    gl.DeleteSync(gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0));
    return texture;
  };
  TracedContext one;
  drawThenFence(one.gl());
  EXPECT_FALSE(one.context().pending.batch.empty());
  const TracedContext other({}, TracedContext::vertexShading(), nullptr, &one);
  one.makeCurrent();
  const GLuint texture = drawThenFence(one.gl());
  EXPECT_TRUE(one.context().pending.batch.empty());
  std::vector<uint32_t> seen(kUploadSize * kUploadSize);
  const OsmesaContext &here = one.below(), &there = other.below();
  const_cast<OsmesaContext&>(there).makeCurrent();  // without GLuRay, which would flush
  there.real().BindTexture(GL_TEXTURE_2D, texture);
  there.real().GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, seen.data());
  const_cast<OsmesaContext&>(here).makeCurrent();
  EXPECT_NEAR(static_cast<int>(seen[kUploadSize * (kUploadSize + 1) / 2] & 0xFF), 129, 6) << "its centre";
}

}  // namespace
}  // namespace gluray::test
