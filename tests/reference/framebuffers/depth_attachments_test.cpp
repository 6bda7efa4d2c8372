// Depth buffers of framebuffer objects: every kind of image, at every attachment point, attached by every
// function. Draws into all of them are traced.
#include "scenes/stage.h"
#include "tests/reference/both.h"
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::test {
namespace {

constexpr glm::ivec2 kDepthSize{kProgramWidth, kProgramHeight};

/// By which functions the images are made and attached.
enum class AttachCalls { core, direct, ext };

struct DepthKind {
  const char* name;
  GLenum image = GL_RENDERBUFFER;  // or a texture target
  GLenum format = GL_DEPTH24_STENCIL8;
  GLenum point = GL_DEPTH_STENCIL_ATTACHMENT;
  GLenum second = GL_NONE;  // the same image is attached there, too
  GLsizei samples = 0;
  AttachCalls calls = AttachCalls::core;
  bool before = false;  // attached before the image has storage
};
void PrintTo(const DepthKind& kind, std::ostream* out) { *out << kind.name; }

struct PixelForm {
  GLenum format, type;
};
PixelForm pixelFormOf(GLenum internal) {
  switch (internal) {
    case GL_RGBA8: return {GL_RGBA, GL_UNSIGNED_BYTE};
    case GL_DEPTH24_STENCIL8: return {GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8};
    case GL_DEPTH32F_STENCIL8: return {GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV};
    default: return {GL_DEPTH_COMPONENT, GL_FLOAT};
  }
}

void storeRenderbuffer(Gl gl, const DepthKind& kind, GLuint name, GLenum format) {
  const auto [w, h] = std::pair(kDepthSize.x, kDepthSize.y);
  if (kind.calls == AttachCalls::direct) {
    gl.NamedRenderbufferStorageMultisample(name, kind.samples, format, w, h);
  } else if (kind.calls == AttachCalls::ext) {
    gl.BindRenderbufferEXT(GL_RENDERBUFFER, name);
    gl.RenderbufferStorageEXT(GL_RENDERBUFFER, format, w, h);
  } else {
    gl.BindRenderbuffer(GL_RENDERBUFFER, name);
    gl.RenderbufferStorageMultisample(GL_RENDERBUFFER, kind.samples, format, w, h);
  }
}

void storeTexture(Gl gl, const DepthKind& kind, GLuint name, GLenum format) {
  const auto [w, h] = std::pair(kDepthSize.x, kDepthSize.y);
  const auto [pixels, type] = pixelFormOf(format);
  const auto kept = static_cast<GLint>(format);
  gl.BindTexture(kind.image, name);
  if (kind.image == GL_TEXTURE_2D_MULTISAMPLE)
    gl.TexImage2DMultisample(kind.image, kind.samples, format, w, h, GL_TRUE);
  else if (kind.image == GL_TEXTURE_2D_ARRAY)
    gl.TexImage3D(kind.image, 0, kept, w, h, 3, 0, pixels, type, nullptr);
  else
    gl.TexImage2D(kind.image, 0, kept, w, h, 0, pixels, type, nullptr);
  gl.BindTexture(kind.image, 0);
}

void attachDepth(Gl gl, const DepthKind& kind, GLuint framebuffer, GLuint name, GLenum point) {
  const bool renderbuffer = kind.image == GL_RENDERBUFFER;
  if (kind.image == GL_TEXTURE_2D_ARRAY)
    gl.FramebufferTextureLayer(GL_FRAMEBUFFER, point, name, 0, 1);
  else if (kind.calls == AttachCalls::direct && renderbuffer)
    gl.NamedFramebufferRenderbuffer(framebuffer, point, GL_RENDERBUFFER, name);
  else if (kind.calls == AttachCalls::direct)
    gl.NamedFramebufferTexture(framebuffer, point, name, 0);
  else if (kind.calls == AttachCalls::ext && renderbuffer)
    gl.FramebufferRenderbufferEXT(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
  else if (kind.calls == AttachCalls::ext)
    gl.FramebufferTexture2DEXT(GL_FRAMEBUFFER, point, kind.image, name, 0);
  else if (renderbuffer)
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, name);
  else
    gl.FramebufferTexture2D(GL_FRAMEBUFFER, point, kind.image, name, 0);
}

GLuint newAttachedImage(Gl gl, const DepthKind& kind) {
  GLuint name = 0;
  if (kind.image != GL_RENDERBUFFER)
    gl.GenTextures(1, &name);
  else if (kind.calls == AttachCalls::direct)
    gl.CreateRenderbuffers(1, &name);
  else
    gl.GenRenderbuffers(1, &name), gl.BindRenderbuffer(GL_RENDERBUFFER, name);
  if (kind.image != GL_RENDERBUFFER) gl.BindTexture(kind.image, name);
  return name;
}

void attachImage(Gl gl, const DepthKind& kind, GLuint framebuffer, GLenum format,
                 std::initializer_list<GLenum> points) {
  const GLuint name = newAttachedImage(gl, kind);
  const auto store = [&] {
    if (kind.image == GL_RENDERBUFFER)
      storeRenderbuffer(gl, kind, name, format);
    else
      storeTexture(gl, kind, name, format);
  };
  if (!kind.before) store();
  for (const GLenum point : points)
    if (point != GL_NONE) attachDepth(gl, kind, framebuffer, name, point);
  if (kind.before) store();
}

/// Makes and binds the framebuffer object.
void bindAttached(Gl gl, const DepthKind& kind) {
  GLuint framebuffer = 0;
  gl.GenFramebuffers(1, &framebuffer), gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  DepthKind color{.name = "", .samples = kind.samples};
  attachImage(gl, color, framebuffer, GL_RGBA8, {GL_COLOR_ATTACHMENT0});
  attachImage(gl, kind, framebuffer, kind.format, {kind.point, kind.second});
  ASSERT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
}

/// Copies colours and depths to a framebuffer object of one sample, from which they can be read.
void resolveAttached(Gl gl, const DepthKind& kind) {
  if (kind.samples == 0) return;
  GLint framebuffer = 0;
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  bindAttached(gl, {.name = "",
                    .format = kind.format,
                    .point = kind.second == GL_NONE ? kind.point : GLenum{GL_DEPTH_STENCIL_ATTACHMENT}});
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
  gl.BlitFramebuffer(0, 0, kDepthSize.x, kDepthSize.y, 0, 0, kDepthSize.x, kDepthSize.y,
                     GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
}

const DepthKind kDepthKinds[] = {
    {"renderbuffer_16", GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, GL_DEPTH_ATTACHMENT},
    {"renderbuffer_24", GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT},
    {"renderbuffer_32", GL_RENDERBUFFER, GL_DEPTH_COMPONENT32, GL_DEPTH_ATTACHMENT},
    {"renderbuffer_32f", GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT},
    {"renderbuffer_any", GL_RENDERBUFFER, GL_DEPTH_COMPONENT, GL_DEPTH_ATTACHMENT},
    {"packed"},
    {"packed_float", GL_RENDERBUFFER, GL_DEPTH32F_STENCIL8},
    {"packed_at_depth_alone", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_ATTACHMENT},
    {"packed_at_both", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT},
    {"packed_at_both_stencil_first", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_STENCIL_ATTACHMENT,
     GL_DEPTH_ATTACHMENT},
    {"packed_before_storage", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_ATTACHMENT,
     GL_STENCIL_ATTACHMENT, 0, AttachCalls::core, true},
    {"packed_multisampled", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, GL_NONE, 4},
    {"packed_multisampled_at_both", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_ATTACHMENT,
     GL_STENCIL_ATTACHMENT, 4},
    {"texture", GL_TEXTURE_2D, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT},
    {"texture_packed", GL_TEXTURE_2D},
    {"texture_packed_at_both", GL_TEXTURE_2D, GL_DEPTH24_STENCIL8, GL_DEPTH_ATTACHMENT,
     GL_STENCIL_ATTACHMENT},
    {"texture_rectangle", GL_TEXTURE_RECTANGLE, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT},
    {"texture_layer", GL_TEXTURE_2D_ARRAY, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT},
    {"texture_multisampled", GL_TEXTURE_2D_MULTISAMPLE, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT,
     GL_NONE, 4},
    {"direct_renderbuffer", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, GL_NONE, 0,
     AttachCalls::direct},
    {"direct_renderbuffer_at_both", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_ATTACHMENT,
     GL_STENCIL_ATTACHMENT, 4, AttachCalls::direct},
    {"direct_texture", GL_TEXTURE_2D, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT, GL_NONE, 0,
     AttachCalls::direct},
    {"ext_renderbuffer", GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT, 0,
     AttachCalls::ext},
    {"ext_texture", GL_TEXTURE_2D, GL_DEPTH24_STENCIL8, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT, 0,
     AttachCalls::ext},
};

/// Silhouettes of multisampled images fall on either side of a sample, and the depth of a resolved pixel may
/// be that of any of its samples.
scenes::Tolerance toleranceOf(const DepthKind& kind) {
  if (kind.samples > 0) return {3, 0.01, 2e-2f, "samples at silhouettes"};
  return {3, 0.01, 5e-5f, "silhouettes, and depths of 16 bits"};
}

class DepthAttachments : public testing::TestWithParam<DepthKind> {};

TEST_P(DepthAttachments, AreTracedFromFixedFunction) {
  const BothStage stage{.width = kDepthSize.x,
                        .height = kDepthSize.y,
                        .folder = "depth_attachments",
                        .prepare = [](scenes::Gl gl) { bindAttached(gl, GetParam()); },
                        .tolerance = toleranceOf(GetParam())};
  const auto draw = [](scenes::Gl gl) {
    scenes::begin(gl, kDepthSize.x, kDepthSize.y);
    scenes::camera(gl, kDepthSize.x, kDepthSize.y);
    gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
    scenes::send(gl, scenes::sphere(24, 36));
    resolveAttached(gl, GetParam());
  };
  EXPECT_GT(compareBoth(stage, GetParam().name, draw).drawsTraced, 0u);
}

TEST_P(DepthAttachments, AreTracedInCoreProfiles) {
  if (GetParam().calls == AttachCalls::ext) GTEST_SKIP() << "core profiles lack EXT_framebuffer_object";
  const Surface surface{.color = Surface::Color::vertex, .lightCount = 2};
  const auto draw = [&](Gl gl) {
    bindAttached(gl, GetParam());
    const ProgramMesh mesh = ball(20);
    const GLuint program = makeProgram(gl, surface);
    const Upload up = upload(gl, mesh, program);
    beginFrame(gl);
    drawSurface(gl, program, up, mesh, perspectiveView(20), surface);
    resolveAttached(gl, GetParam());
  };
  expectSame(GetParam().name, draw, 1, coreWish(4, 5), toleranceOf(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Kinds, DepthAttachments, testing::ValuesIn(kDepthKinds),
                         [](const auto& info) { return std::string(info.param.name); });

/// What a framebuffer object lacks or gets later.
TEST(DepthAttachmentsChange, AreSeenWhenTheyChange) {
  const BothStage stage{.width = kDepthSize.x,
                        .height = kDepthSize.y,
                        .folder = "depth_attachments",
                        .prepare = [](scenes::Gl gl) { bindAttached(gl, kDepthKinds[5]); },
                        .tolerance = toleranceOf(kDepthKinds[5])};
  const auto draw = [](scenes::Gl gl) {
    const auto frame = [&] {
      scenes::begin(gl, kDepthSize.x, kDepthSize.y);
      scenes::camera(gl, kDepthSize.x, kDepthSize.y);
      gl.Enable(GL_LIGHTING), gl.Enable(GL_LIGHT0);
      scenes::send(gl, scenes::sphere(24, 36));
    };
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, 0);
    frame();  // without depth: the real OpenGL draws
    GLint framebuffer = 0;
    gl.GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
    attachImage(gl, kDepthKinds[8], static_cast<GLuint>(framebuffer), GL_DEPTH24_STENCIL8,
                {GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT});
    frame();
  };
  const auto counts = compareBoth(stage, "change", draw);
  EXPECT_GT(counts.drawsTraced, 0u);
  EXPECT_GT(counts.drawsRasterised, 0u);
}

}  // namespace
}  // namespace gluray::test
