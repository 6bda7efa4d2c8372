// Depth blits between framebuffer objects, which GLuRay replaces by copies where the result is the same:
// images, depths, stencil values and errors must equal the real OpenGL's either way.
#include "settings/quirks.h"
#include "tests/support/traced_context.h"

#include <gtest/gtest.h>

#include <ostream>
#include <vector>

namespace gluray::test {
namespace {

using Gl = const gl::RealGl&;
constexpr int kBlitSize = 32;

/// How a framebuffer keeps its depth.
struct Store {
  GLenum format = GL_DEPTH_COMPONENT24;
  bool texture = false, stencil = false;  // stencil: attached as such, too
  GLsizei samples = 0;
};

struct Buffers {
  GLuint framebuffer = 0, depth = 0;
};

GLuint depthTexture(Gl gl, GLenum format) {
  const bool packed = format == GL_DEPTH24_STENCIL8;
  GLuint name = 0;
  gl.GenTextures(1, &name), gl.BindTexture(GL_TEXTURE_2D, name);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  gl.TexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), kBlitSize, kBlitSize, 0,
                packed ? GL_DEPTH_STENCIL : GL_DEPTH_COMPONENT,
                packed ? GLenum{GL_UNSIGNED_INT_24_8} : GLenum{GL_FLOAT}, nullptr);
  return name;
}

GLuint renderbuffer(Gl gl, GLenum format, GLsizei samples) {
  GLuint name = 0;
  gl.GenRenderbuffers(1, &name), gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, kBlitSize, kBlitSize);
  return name;
}

/// Bound for drawing, and cleared to a depth.
Buffers make(Gl gl, const Store& store, double depth) {
  Buffers b;
  gl.GenFramebuffers(1, &b.framebuffer), gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, b.framebuffer);
  gl.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                             renderbuffer(gl, GL_RGBA8, store.samples));
  const auto attach = [&](GLenum point) {
    if (store.texture)
      gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, point, GL_TEXTURE_2D, b.depth, 0);
    else
      gl.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, point, GL_RENDERBUFFER, b.depth);
  };
  b.depth = store.texture ? depthTexture(gl, store.format) : renderbuffer(gl, store.format, store.samples);
  attach(GL_DEPTH_ATTACHMENT);
  if (store.stencil) attach(GL_STENCIL_ATTACHMENT);
  gl.ClearDepth(depth), gl.ClearColor(static_cast<float>(depth), 0.5f, 0, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return b;
}

/// A smaller rectangle of another colour and depth; by a scissored clear, which needs no program.
void mark(Gl gl, double depth) {
  gl.Enable(GL_SCISSOR_TEST), gl.Scissor(5, 7, 11, 9);
  gl.ClearDepth(depth), gl.ClearColor(0, static_cast<float>(depth), 1, 1);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.Disable(GL_SCISSOR_TEST);
}

void blit(Gl gl, GLbitfield mask = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GLenum filter = GL_NEAREST) {
  gl.BlitFramebuffer(0, 0, kBlitSize, kBlitSize, 0, 0, kBlitSize, kBlitSize, mask, filter);
}

struct BlitCase {
  const char* name;
  Store from, to;
  void (*blits)(Gl gl);
  int copies;                                   // expected number of blits replaced by depth copies
  void (*before)(Gl gl, Buffers to) = nullptr;  // with the target bound for drawing
};
void PrintTo(const BlitCase& c, std::ostream* out) { *out << c.name; }

constexpr Store kPlain, kTexture{.texture = true}, kPacked{.format = GL_DEPTH24_STENCIL8, .texture = true},
    kStencil{.format = GL_DEPTH24_STENCIL8, .stencil = true}, kFloat{.format = GL_DEPTH_COMPONENT32F},
    kSamples{.samples = 4};

void setStencil(Gl gl, Buffers to) {
  gl.FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, GL_TEXTURE_2D, to.depth, 0);
  gl.ClearStencil(77), gl.Clear(GL_STENCIL_BUFFER_BIT);
}

const BlitCase kBlitCases[] = {
    {"Renderbuffers", kPlain, kPlain, [](Gl gl) { blit(gl); }, 1},
    {"DepthAlone", kPlain, kPlain, [](Gl gl) { blit(gl, GL_DEPTH_BUFFER_BIT); }, 1},
    {"Floats", kFloat, kFloat, [](Gl gl) { blit(gl); }, 1},
    {"TextureToRenderbuffer", kTexture, kPlain, [](Gl gl) { blit(gl); }, 1},
    {"RenderbufferToTexture", kPlain, kTexture, [](Gl gl) { blit(gl); }, 1},
    {"Part", kPlain, kPlain,
     [](Gl gl) { gl.BlitFramebuffer(3, 4, 20, 12, 3, 4, 20, 12, GL_DEPTH_BUFFER_BIT, GL_NEAREST); }, 1},
    {"StencilNeverSet", kPacked, kPacked, [](Gl gl) { blit(gl); }, 1},
    {"StencilSet", kPacked, kPacked, [](Gl gl) { blit(gl); }, 0, setStencil},
    {"StencilDrawn", kPacked, kPacked, [](Gl gl) { blit(gl); }, 0,
     [](Gl gl, Buffers) { gl.Enable(GL_STENCIL_TEST), gl.Disable(GL_STENCIL_TEST); }},
    {"StencilUploaded", kPacked, kPacked, [](Gl gl) { blit(gl); }, 0,
     [](Gl gl, Buffers to) {
       const std::vector<GLuint> values(kBlitSize * kBlitSize, 0x80000055u);
       gl.BindTexture(GL_TEXTURE_2D, to.depth);
       gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kBlitSize, kBlitSize, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8,
                        values.data());
     }},
    {"StencilToo", kStencil, kStencil,
     [](Gl gl) {
       gl.ClearStencil(9), gl.Clear(GL_STENCIL_BUFFER_BIT);
       blit(gl, GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
     },
     0},
    {"Moved", kPlain, kPlain,
     [](Gl gl) { gl.BlitFramebuffer(0, 0, 20, 20, 3, 4, 23, 24, GL_DEPTH_BUFFER_BIT, GL_NEAREST); }, 0},
    {"Scaled", kPlain, kPlain,
     [](Gl gl) { gl.BlitFramebuffer(0, 0, 16, 16, 0, 0, 32, 32, GL_DEPTH_BUFFER_BIT, GL_NEAREST); }, 0},
    {"Mirrored", kPlain, kPlain,
     [](Gl gl) { gl.BlitFramebuffer(0, 0, 32, 32, 32, 0, 0, 32, GL_DEPTH_BUFFER_BIT, GL_NEAREST); }, 0},
    {"BeyondTheEdge", kPlain, kPlain,
     [](Gl gl) { gl.BlitFramebuffer(8, 8, 60, 60, 8, 8, 60, 60, GL_DEPTH_BUFFER_BIT, GL_NEAREST); }, 0},
    {"Scissored", kPlain, kPlain,
     [](Gl gl) {
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(8, 2, 9, 30);
       blit(gl);
       gl.Disable(GL_SCISSOR_TEST);
     },
     0},
    {"ScissorAround", kPlain, kPlain,
     [](Gl gl) {
       gl.Enable(GL_SCISSOR_TEST), gl.Scissor(0, 0, kBlitSize, kBlitSize);
       blit(gl);
       gl.Disable(GL_SCISSOR_TEST);
     },
     1},
    {"DeletedTexture", kPlain, kTexture, [](Gl gl) { blit(gl); }, 0,
     [](Gl gl, Buffers to) {
       gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
       gl.DeleteTextures(1, &to.depth);  // lives on in the framebuffer
       gl.BindTexture(GL_TEXTURE_2D, to.depth);
       gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
       gl.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kBlitSize, kBlitSize, 0, GL_DEPTH_COMPONENT,
                     GL_FLOAT, nullptr);
       gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
     }},
    {"DeletedRenderbuffer", kPlain, kPlain, [](Gl gl) { blit(gl); }, 0,
     [](Gl gl, Buffers to) {
       gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
       gl.DeleteRenderbuffers(1, &to.depth);
       gl.BindRenderbuffer(GL_RENDERBUFFER, to.depth);
       gl.RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, kBlitSize, kBlitSize);
       gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, to.framebuffer);
     }},
    {"OtherFormat", kFloat, kPlain, [](Gl gl) { blit(gl); }, 0},
    {"Resolved", kSamples, kPlain, [](Gl gl) { blit(gl); }, 0},
    {"Linear", kPlain, kPlain, [](Gl gl) { blit(gl, GL_DEPTH_BUFFER_BIT, GL_LINEAR); }, 0},
    {"UnknownMask", kPlain, kPlain, [](Gl gl) { blit(gl, GL_DEPTH_BUFFER_BIT | 0x10); }, 0},
    {"DepthMaskIsNoMatter", kPlain, kPlain,
     [](Gl gl) {
       gl.DepthMask(GL_FALSE);
       blit(gl);
       gl.DepthMask(GL_TRUE);
     },
     1},
    {"InAList", kPlain, kPlain,
     [](Gl gl) {
       const GLuint list = gl.GenLists(1);
       gl.NewList(list, GL_COMPILE), blit(gl), gl.EndList();
       gl.CallList(list);
     },
     0},
    {"Conditional", kPlain, kPlain,
     [](Gl gl) {
       GLuint query = 0;
       gl.GenQueries(1, &query);
       gl.BeginQuery(GL_SAMPLES_PASSED, query), gl.EndQuery(GL_SAMPLES_PASSED);
       gl.BeginConditionalRender(query, GL_QUERY_WAIT);
       blit(gl);
       gl.EndConditionalRender();
     },
     0},
    {"ToTheWindow", kPlain, kPlain,
     [](Gl gl) {
       gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
       blit(gl, GL_COLOR_BUFFER_BIT);
     },
     0},
    {"Incomplete", kPlain, kPlain,
     [](Gl gl) {
       gl.FramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                  renderbuffer(gl, GL_DEPTH_COMPONENT24, 0));
       blit(gl);
     },
     0},
};

struct BlitResult {
  std::vector<GLenum> errors;
  std::vector<uint32_t> color;
  std::vector<float> depth;
  std::vector<uint8_t> stencil;
  GLint messages = 0;  // for debugging, which the blits led to
};

BlitResult runBlit(Gl gl, const BlitCase& c) {
  BlitResult r;
  const Buffers from = make(gl, c.from, 0.625);
  mark(gl, 0.3);
  const Buffers to = make(gl, c.to, 0.875);
  if (c.before) c.before(gl, to);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer);
  const auto noteErrors = [&] {
    for (GLenum error; (error = gl.GetError()) != GL_NO_ERROR;) r.errors.push_back(error);
    r.errors.push_back(GL_NO_ERROR);
  };
  noteErrors();
  gl.Enable(GL_DEBUG_OUTPUT);
  gl.GetDebugMessageLog(1000, 0, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr);
  c.blits(gl);
  gl.GetIntegerv(GL_DEBUG_LOGGED_MESSAGES, &r.messages), gl.Disable(GL_DEBUG_OUTPUT);
  noteErrors();
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, to.framebuffer);
  r.color.resize(kBlitSize * kBlitSize), r.depth.resize(kBlitSize * kBlitSize);
  gl.ReadPixels(0, 0, kBlitSize, kBlitSize, GL_RGBA, GL_UNSIGNED_BYTE, r.color.data());
  gl.ReadPixels(0, 0, kBlitSize, kBlitSize, GL_DEPTH_COMPONENT, GL_FLOAT, r.depth.data());
  GLint has = 0;
  gl.GetFramebufferAttachmentParameteriv(GL_READ_FRAMEBUFFER, GL_STENCIL_ATTACHMENT,
                                         GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &has);
  if (has != GL_NONE) {
    r.stencil.resize(kBlitSize * kBlitSize);
    gl.ReadPixels(0, 0, kBlitSize, kBlitSize, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, r.stencil.data());
  }
  noteErrors();
  return r;
}

class DepthBlits : public testing::TestWithParam<BlitCase> {};

TEST_P(DepthBlits, AreThoseOfTheRealOpenGl) {
  const BlitCase& c = GetParam();
  BlitResult expected;
  {
    const auto real = OsmesaContext::create();
    ASSERT_TRUE(real);
    expected = runBlit(real->real(), c);
  }
  const TracedContext traced;
  const uint64_t before = useCount(Quirk::softwareDepthBlit);
  const BlitResult got = runBlit(traced.gl(), c);
  EXPECT_EQ(got.errors, expected.errors);
  EXPECT_EQ(got.messages, expected.messages);
  EXPECT_EQ(got.color, expected.color);
  EXPECT_EQ(got.depth, expected.depth);
  EXPECT_EQ(got.stencil, expected.stencil);
  EXPECT_EQ(useCount(Quirk::softwareDepthBlit) - before, static_cast<uint64_t>(c.copies));
}

INSTANTIATE_TEST_SUITE_P(All, DepthBlits, testing::ValuesIn(kBlitCases),
                         [](const auto& info) { return info.param.name; });

TEST(DepthBlits, AreBlitsWhereSwitchedOff) {
  Settings settings = TracedContext::vertexShading();
  ASSERT_EQ(readQuirks("software-depth-blit=off", settings.quirks), "");
  const TracedContext traced({}, settings);
  const uint64_t before = useCount(Quirk::softwareDepthBlit);
  runBlit(traced.gl(), kBlitCases[0]);
  EXPECT_EQ(useCount(Quirk::softwareDepthBlit), before);
}

/// In another context of the share group: stencil values set there count here.
TEST(DepthBlits, KnowStencilValuesOfOtherContexts) {
  TracedContext one;
  const TracedContext other({}, TracedContext::vertexShading(), nullptr, &one);
  other.gl().Enable(GL_STENCIL_TEST);
  one.makeCurrent();
  const uint64_t before = useCount(Quirk::softwareDepthBlit);
  for (const BlitCase& c : kBlitCases)
    if (std::string_view(c.name) == "StencilNeverSet") runBlit(one.gl(), c);
  EXPECT_EQ(useCount(Quirk::softwareDepthBlit), before);
}

}  // namespace
}  // namespace gluray::test
