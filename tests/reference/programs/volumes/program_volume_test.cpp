// Volumes of a ray caster that these tests write themselves: formats of voxels, changes, and what is left to
// the real OpenGL, each against its picture.
#include "gl/context/context.h"
#include "tests/reference/programs/volumes/volume_stage.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace gluray::test {
namespace {

/// Changes state or textures before the draw.
using Before = std::function<void(Gl)>;
const Before kNothing = [](Gl) {};

struct VolumeCase {
  VoxelImage image;
  Before before = kNothing;
  float scale = 1, bias = 0;
  CasterText text;
  double degrees = 30;
};

DrawProgram drawing(const VolumeCase& c, std::string* why = nullptr) {
  return [c, why](Gl gl) {
    const GLuint program = makeCaster(gl, c.text);
    const CastBox box(gl, program);
    makeVoxels(gl, c.image);
    beginFrame(gl);
    box.begin(gl, perspectiveView(c.degrees), c.scale, c.bias);
    c.before(gl);
    box.draw(gl);
    if (gl::Context* const context = gl::t_thread.context; context && why) {
      const gl::ProgramState& state = context->shadow.program();
      *why = state.why.empty() && state.known ? state.known->why : state.why;
    }
  };
}

void expectTraced(const std::string& name, const VolumeCase& c) {
  SCOPED_TRACE(name);
  expectSame("volume-" + name, drawing(c), 1, {}, kVolumeTolerance, casterFamily(c.text.depths));
}

/// The real OpenGL draws it, for a reason with these words.
void expectLeft(const std::string& name, const VolumeCase& c, const std::string& words) {
  SCOPED_TRACE(name);
  std::string why;
  const scenes::Tolerance same = {0, 0, 0, "the same draws by the same OpenGL"};
  expectSame("volume-" + name, drawing(c, &why), 0, {}, same, casterFamily(c.text.depths));
  EXPECT_NE(why.find(words), std::string::npos) << why;
}

TEST(ProgramVolumes, FormatsOfVoxels) {
  for (const auto& [name, format] :
       {std::pair("floats", GL_R32F), std::pair("halves", GL_R16F), std::pair("bytes", GL_R8),
        std::pair("words", GL_R16), std::pair("signed-words", GL_R16_SNORM),
        std::pair("signed-bytes", GL_R8_SNORM)})
    for (const GLint filter : {GL_LINEAR, GL_NEAREST}) {
      VolumeCase c{.image = {.format = static_cast<GLenum>(format), .filter = filter}};
      if (name[0] == 's') c.scale = c.bias = 0.5f;
      expectTraced(std::string(name) + (filter == GL_LINEAR ? "" : "-nearest"), c);
    }
}

TEST(ProgramVolumes, SizesScalesAndViews) {
  expectTraced("large", {.image = {.size = {40, 33, 25}}});
  expectTraced("thin", {.image = {.size = {20, 1, 3}}});
  expectTraced("one", {.image = {.size = {1, 1, 1}}, .bias = 0.4f});
  expectTraced("inverted", {.scale = -1.3f, .bias = 1.1f});
  expectTraced("straight", {.degrees = 0});
  expectTraced("from-behind", {.degrees = 170});
}

TEST(ProgramVolumes, BackFacesFromInside) {
  VolumeCase c;
  c.before = [](Gl gl) { gl.CullFace(GL_FRONT); };
  expectTraced("back-faces", c);
  c.before = [](Gl gl) { gl.FrontFace(GL_CW); };
  expectTraced("clockwise", c);
}

TEST(ProgramVolumes, ScissorsAndViewports) {
  VolumeCase c;
  c.before = [](Gl gl) { gl.Enable(GL_SCISSOR_TEST), gl.Scissor(60, 40, 50, 70); };
  expectTraced("scissor", c);
  c.before = [](Gl gl) { gl.Viewport(30, -20, 150, 120); };
  expectTraced("viewport", c);
}

/// Draws a sheet that cuts the box, by a program that GLuRay does not know.
void drawSheet(Gl gl) {
  GLint last = 0, array = 0;
  gl.GetIntegerv(GL_CURRENT_PROGRAM, &last), gl.GetIntegerv(GL_VERTEX_ARRAY_BINDING, &array);
  const GLuint program = makeUnknownProgram(gl);
  const ProgramMesh mesh = sheet(4);
  const Upload up = upload(gl, mesh, program);
  gl.Disable(GL_BLEND), gl.Disable(GL_CULL_FACE), gl.DepthMask(GL_TRUE);
  drawByUnknown(gl, program, up, mesh, perspectiveView(-20));
  gl.Enable(GL_BLEND), gl.Enable(GL_CULL_FACE), gl.DepthMask(GL_FALSE);
  gl.UseProgram(static_cast<GLuint>(last)), gl.BindVertexArray(static_cast<GLuint>(array));
}

TEST(ProgramVolumes, FramebuffersDepthsHideBoxes) {
  expectTraced("depth-test", {.before = drawSheet});
  VolumeCase c;
  c.before = [](Gl gl) { drawSheet(gl), gl.Disable(GL_DEPTH_TEST); };
  expectTraced("no-depth-test", c);
  c.before = [](Gl gl) { drawSheet(gl), gl.DepthFunc(GL_LESS); };
  expectTraced("less", c);
}

/// Copies the framebuffer's depth into a texture on unit 3.
void copyDepths(Gl gl) {
  GLuint name = 0;
  gl.GenTextures(1, &name);
  gl.ActiveTexture(GL_TEXTURE3), gl.BindTexture(GL_TEXTURE_2D, name);
  gl.CopyTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 0, 0, kProgramWidth, kProgramHeight, 0);
  for (const GLenum what : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    gl.TexParameteri(GL_TEXTURE_2D, what, GL_NEAREST);
}

TEST(ProgramVolumes, RaysEndAtDepths) {
  VolumeCase c{.text = {.depths = true}};
  c.before = [](Gl gl) { drawSheet(gl), copyDepths(gl), gl.Disable(GL_DEPTH_TEST); };
  expectTraced("depths", c);
  c.before = copyDepths;
  expectTraced("open-depths", c);
}

TEST(ProgramVolumes, OtherChannelsDoNotCount) {
  VolumeCase c;
  c.before = [](Gl gl) {
    std::vector<float> values;
    for (int i = 0; i < 4 * 5 * 6; ++i) values.insert(values.end(), {static_cast<float>(i % 7) / 6, -3});
    gl.ActiveTexture(GL_TEXTURE0);
    gl.TexImage3D(GL_TEXTURE_3D, 0, GL_RG32F, 4, 5, 6, 0, GL_RG, GL_FLOAT, values.data());
  };
  expectTraced("two-channels", c);
}

TEST(ProgramVolumes, ChangedVoxelsAreSeen) {
  const auto draws = [](Gl gl) {
    const CastBox box(gl, makeCaster(gl));
    makeVoxels(gl, {});
    for (int i = 0; i < 4; ++i) {
      beginFrame(gl);
      box.begin(gl, perspectiveView(30));
      // Of one part, then of another one, then of all.
      if (i == 1) changeVoxels(gl, {2, 1, 3}, {5, 3, 4}, 0.9f);
      if (i == 2) changeVoxels(gl, {0, 5, 0}, {9, 2, 11}, 0.7f);
      if (i == 3) changeVoxels(gl, {0, 0, 0}, {9, 7, 11}, 0.6f);
      gl.Viewport(100 * (i % 2), 75 * (i / 2), 100, 75);
      gl.Enable(GL_SCISSOR_TEST), gl.Scissor(100 * (i % 2), 75 * (i / 2), 100, 75);
      box.draw(gl);
    }
  };
  expectSame("volume-changed", draws, 4, {}, kVolumeTolerance, casterFamily());
}

TEST(ProgramVolumes, ChangedTablesAndTexturesAreSeen) {
  const auto draws = [](Gl gl) {
    const CastBox box(gl, makeCaster(gl));
    const GLuint first = makeVoxels(gl, {});
    const GLuint second = makeVoxels(gl, {.size = {5, 5, 5}, .format = GL_R16});
    beginFrame(gl);
    gl.Enable(GL_SCISSOR_TEST);
    for (int i = 0; i < 4; ++i) {
      box.begin(gl, perspectiveView(30));
      gl.ActiveTexture(GL_TEXTURE0), gl.BindTexture(GL_TEXTURE_3D, i % 2 ? first : second);
      const float entry[] = {0.4f, 0.6f};
      gl.ActiveTexture(GL_TEXTURE1);
      if (i == 2) gl.TexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 2, 1, GL_RED, GL_FLOAT, entry);
      gl.Viewport(100 * (i % 2), 75 * (i / 2), 100, 75), gl.Scissor(100 * (i % 2), 75 * (i / 2), 100, 75);
      box.draw(gl);
    }
  };
  expectSame("volume-tables", draws, 4, {}, kVolumeTolerance, casterFamily());
}

TEST(ProgramVolumes, UnknownStatementsAreLeftToTheRealOne) {
  expectLeft("statement", {.text = {.more = "sum.x *= 0.99;\n"}}, "no family fits");
}

TEST(ProgramVolumes, WithoutBlendingColorsAreReplaced) {
  VolumeCase c;
  c.before = [](Gl gl) {
    gl.Disable(GL_BLEND), gl.ClearColor(0.3f, 0.6f, 0.2f, 1), gl.Clear(GL_COLOR_BUFFER_BIT);
  };
  expectTraced("blend-off", c);
  c.text.depths = true;
  c.before = [](Gl gl) { drawSheet(gl), copyDepths(gl), gl.Disable(GL_BLEND); };
  expectTraced("blend-off-depths", c);
}

TEST(ProgramVolumes, OtherBlendingIsLeftToTheRealOne) {
  const auto left = [](const std::string& name, const Before& before, const std::string& words) {
    VolumeCase c;
    c.before = before;
    expectLeft(name, c, words);
  };
  const std::string blended = "it is not blended over the framebuffer";
  left(
      "blend-alpha", [](Gl gl) { gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); }, blended);
  left(
      "blend-sum", [](Gl gl) { gl.BlendFunc(GL_ONE, GL_ONE); }, blended);
  left(
      "blend-separate", [](Gl gl) { gl.BlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ZERO); },
      blended);
  left(
      "blend-maximum", [](Gl gl) { gl.BlendEquation(GL_MAX); }, blended);
  left(
      "depth-writes", [](Gl gl) { gl.DepthMask(GL_TRUE); }, "it writes depth");
  for (const GLenum depths : {GL_GREATER, GL_GEQUAL, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS, GL_NEVER})
    left(
        "depth-test-" + std::to_string(depths),
        [depths](Gl gl) {
          gl.ClearDepth(0.5), gl.Clear(GL_DEPTH_BUFFER_BIT);
          gl.DepthFunc(depths);
        },
        "it has another depth test");
  left(
      "both-faces", [](Gl gl) { gl.Disable(GL_CULL_FACE); }, "its faces are not culled");
  left(
      "lines", [](Gl gl) { gl.PolygonMode(GL_FRONT_AND_BACK, GL_LINE); }, "its faces are not filled");
  left(
      "depth-range", [](Gl gl) { gl.DepthRange(0, 0.5); }, "its depth range is not 0 to 1");
  left(
      "color-mask", [](Gl gl) { gl.ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE); },
      "it does not write all channels");
  left(
      "polygon-offset",
      [](Gl gl) { drawSheet(gl), gl.Enable(GL_POLYGON_OFFSET_FILL), gl.PolygonOffset(0, 1e6f); },
      "polygon offset");
  left(
      "stencil", [](Gl gl) { gl.Enable(GL_STENCIL_TEST); }, "stencil");
}

TEST(ProgramVolumes, RareStateIsObserved) {
  const auto same = [](const std::string& name, const Before& before) {
    SCOPED_TRACE(name);
    VolumeCase c;
    c.before = [before](Gl gl) { drawSheet(gl), before(gl); };
    expectSame("volume-" + name, drawing(c), -1, {}, kVolumeTolerance, casterFamily());
  };
  same("no-offset", [](Gl gl) { gl.Enable(GL_POLYGON_OFFSET_FILL); });
  same("discard", [](Gl gl) { gl.Enable(GL_RASTERIZER_DISCARD); });
  same("depth-clamp", [](Gl gl) { gl.Enable(GL_DEPTH_CLAMP); });
  same("srgb", [](Gl gl) { gl.Enable(GL_FRAMEBUFFER_SRGB); });
  same("dither-off", [](Gl gl) { gl.Disable(GL_DITHER); });
  same("no-draw-buffer", [](Gl gl) { gl.DrawBuffer(GL_NONE); });
  same("least-numbers", [](Gl gl) {
    const std::vector<int8_t> least(5 * 4 * 6, -128);
    gl.ActiveTexture(GL_TEXTURE0), gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    makeVoxels(gl, {.format = GL_R8_SNORM});
    gl.TexSubImage3D(GL_TEXTURE_3D, 0, 2, 1, 3, 5, 4, 6, GL_RED, GL_BYTE, least.data());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  });
}

TEST(ProgramVolumes, OtherTexturesAreLeftToTheRealOne) {
  const auto voxels = [](GLenum what, GLint value) {
    return
        [what, value](Gl gl) { gl.ActiveTexture(GL_TEXTURE0), gl.TexParameteri(GL_TEXTURE_3D, what, value); };
  };
  const auto left = [](const std::string& name, const Before& before, const std::string& words) {
    VolumeCase c;
    c.before = before;
    expectLeft(name, c, words);
  };
  left("repeated", voxels(GL_TEXTURE_WRAP_R, GL_REPEAT), "not clamped to its edge");
  left("two-filters", voxels(GL_TEXTURE_MIN_FILTER, GL_NEAREST), "sampling parameters");
  left("swizzled", voxels(GL_TEXTURE_SWIZZLE_R, GL_ONE), "sampling parameters");
  left(
      "base-level",
      [](Gl gl) {
        const std::vector<float> values(4 * 3 * 5, 0.8f);
        gl.ActiveTexture(GL_TEXTURE0);
        gl.TexImage3D(GL_TEXTURE_3D, 1, GL_R32F, 4, 3, 5, 0, GL_RED, GL_FLOAT, values.data());
        gl.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_BASE_LEVEL, 1);
      },
      "sampling parameters");
  left(
      "no-numbers",
      [](Gl gl) {
        changeVoxels(gl, {1, 1, 1}, {1, 1, 1}, NAN);
      },
      "no numbers");
}

}  // namespace
}  // namespace gluray::test
