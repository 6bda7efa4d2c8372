// Culled draws that are blended by an alpha that is 1 but for rounding: it comes from vertices, or is
// above 1.
#include "tests/reference/culled/culled_frames.h"
#include "tests/reference/culled/culled_programs.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace gluray::test {
namespace {

using namespace culled;

constexpr GLuint kTint = 5;  // location of the attribute

const std::string kTinted = replacedIn(
    replacedIn(replacedIn(kCulledVertex, "in vec3 normal;", "in vec3 normal;\nin vec4 tint;\nout vec4 k;"),
               "place = position;", "place = position, k = tint;"),
    "#version 150", "#version 150\n#extension GL_ARB_explicit_attrib_location : enable");

/// Fragments that get their alpha from k.
const std::string kCopied = replacedIn(
    replacedIn(kCulledFragment, "out vec4 color;", "in vec4 k;\nout vec4 color;"), "1.0);\n}", "k.a);\n}");

struct BlendedScene {
  std::string vertex = kTinted, fragment = kCopied;
  std::function<void(Gl, GLuint vertices)> tint = [](Gl, GLuint) {};  // sends the attribute
  std::function<void(Gl, int frame)> before = [](Gl, int) {};         // each draw
  std::function<void(Gl)> blend = [](Gl gl) { gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA); };
  std::function<void(Gl)> prepare = [](Gl) {};
};

gl::Statistics compareBlended(const std::string& name, const BlendedScene& scene) {
  GLuint program = 0;
  const ProgramMesh mesh = shells(5, 100);
  return compareFrames(
      name, 5,
      [&](Gl gl) {
        program =
            makeProgram(gl, replacedIn(scene.vertex, "in vec4 tint", "layout(location = 5) in vec4 tint"),
                        scene.fragment);
        send(gl, mesh, program);
        scene.tint(gl, static_cast<GLuint>(mesh.positions.size()));
        scene.prepare(gl);
      },
      [&](Gl gl, int frame) {
        clear(gl);
        gl.UseProgram(program);
        turn(gl, program, frame);
        gl.Enable(GL_BLEND);
        scene.blend(gl);
        scene.before(gl, frame);
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
      });
}

/// Tints, all the same but for the alpha of vertex `odd`.
void sendTints(Gl gl, GLuint vertices, float alpha, float oddAlpha, GLuint odd = 777) {
  std::vector<glm::vec4> tints(vertices, glm::vec4(0.3f, 0.6f, 0.9f, alpha));
  tints[odd].a = oddAlpha;
  GLuint buffer = 0;
  gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices * sizeof(glm::vec4)), tints.data(),
                GL_DYNAMIC_DRAW);
  gl.EnableVertexAttribArray(kTint);
  gl.VertexAttribPointer(kTint, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
}

BlendedScene tinted(float alpha, float oddAlpha) {
  BlendedScene scene;
  scene.tint = [=](Gl gl, GLuint vertices) { sendTints(gl, vertices, alpha, oddAlpha); };
  return scene;
}

TEST(BlendedDraws, AreCulledWhereTheAlphaOfAllVerticesIsOne) {
  EXPECT_GT(compareBlended("ones", tinted(1, 1)).drawsCulled, 0u);
  EXPECT_EQ(compareBlended("halves", tinted(0.5f, 0.5f)).drawsCulled, 0u);
  EXPECT_EQ(compareBlended("one_half", tinted(1, 0.5f)).drawsCulled, 0u);
  EXPECT_EQ(compareBlended("nearly", tinted(1, 0.9999f)).drawsCulled, 0u);
}

TEST(BlendedDraws, AreCulledWhateverTheTypeOfTheArray) {
  const auto send = [](GLint size, GLenum type, bool normalized, GLubyte value) {
    BlendedScene scene;
    scene.tint = [=](Gl gl, GLuint vertices) {
      const std::vector<GLubyte> bytes(size_t{vertices} * 4, value);
      GLuint buffer = 0;
      gl.GenBuffers(1, &buffer), gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
      gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
      gl.EnableVertexAttribArray(kTint);
      gl.VertexAttribPointer(kTint, size, type, normalized, 4, nullptr);
    };
    return scene;
  };
  EXPECT_GT(compareBlended("bytes", send(4, GL_UNSIGNED_BYTE, true, 255)).drawsCulled, 0u);
  EXPECT_GT(compareBlended("three", send(3, GL_UNSIGNED_BYTE, true, 100)).drawsCulled, 0u);
  EXPECT_GT(compareBlended("numbers", send(4, GL_UNSIGNED_BYTE, false, 1)).drawsCulled, 0u);
  EXPECT_EQ(compareBlended("below", send(4, GL_UNSIGNED_BYTE, true, 254)).drawsCulled, 0u);
}

TEST(BlendedDraws, LookAtCurrentValuesWhereThereIsNoArray) {
  const auto current = [](float alpha) {
    BlendedScene scene;
    scene.before = [=](Gl gl, int) { gl.VertexAttrib4f(kTint, 1, 1, 1, alpha); };
    return scene;
  };
  EXPECT_GT(compareBlended("current", current(1)).drawsCulled, 0u);
  EXPECT_EQ(compareBlended("current_half", current(0.5f)).drawsCulled, 0u);
}

TEST(BlendedDraws, FollowArraysThatChange) {
  BlendedScene scene = tinted(1, 1);
  scene.before = [](Gl gl, int frame) {
    GLint buffer = 0;
    gl.GetVertexAttribiv(kTint, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer));
    const std::vector<glm::vec4> some(4000, glm::vec4(1, 1, 1, frame < 3 ? 1.0f : 0.3f));
    if (frame > 1)
      gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(some.size() * sizeof(glm::vec4)),
                       some.data());
  };
  const gl::Statistics counts = compareBlended("changed", scene);
  EXPECT_GT(counts.drawsCulled, 0u);
  EXPECT_LE(counts.drawsCulled, 2u);
}

TEST(BlendedDraws, FollowAlphaThroughFragmentShaders) {
  const auto with = [](const std::string& functions, const std::string& color) {
    BlendedScene scene = tinted(1, 1);
    scene.fragment = replacedIn(kCopied, "void main() {", functions + "\nvoid main() {");
    const size_t at = scene.fragment.rfind("color = ");
    scene.fragment = scene.fragment.substr(0, at) + "color = " + color + ";\n}";
    return scene;
  };
  const std::string fog =
      "vec4 fog(vec4 c, float f) { if (f >= 1.0) return c; return vec4(mix(vec3(0.2, 0.3, 0.4), c.rgb, f), "
      "c.a); }";
  EXPECT_GT(compareBlended("fog", with(fog, "fog(vec4(light, k.a), 1.2 - place.x)")).drawsCulled, 0u);
  const std::string shine = "float shine(vec3 n) { return clamp(dot(n, vec3(0.6, 0.0, 0.8)), 0.0, 1.0); }";
  EXPECT_GT(compareBlended(
                "above", with(shine, "vec4(light, 1.0) * (vec4(0.2, 0.2, 0.2, 1.0) + shine(n)) + shine(-n)"))
                .drawsCulled,
            0u);
  EXPECT_EQ(compareBlended("below", with(shine, "vec4(light, 1.0 - 0.5 * shine(n))")).drawsCulled, 0u);
}

/// Premultiplied colours; alpha of the framebuffer kept; functions that need what is below.
TEST(BlendedDraws, OfAllFunctionsThatReplaceColors) {
  const auto by = [](const std::function<void(Gl)>& blend) {
    BlendedScene scene = tinted(1, 1);
    scene.blend = blend;
    return scene;
  };
  const auto over = [](Gl gl) { gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); };
  EXPECT_GT(compareBlended("over", by(over)).drawsCulled, 0u);
  const auto apart = [](Gl gl) {
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  };
  EXPECT_GT(compareBlended("apart", by(apart)).drawsCulled, 0u);
  const auto kept = [](Gl gl) {
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  };
  EXPECT_GT(compareBlended("kept", by(kept)).drawsCulled, 0u);
  const auto added = [](Gl gl) { gl.BlendFunc(GL_SRC_ALPHA, GL_ONE); };
  EXPECT_EQ(compareBlended("added", by(added)).drawsCulled, 0u);
  const auto most = [](Gl gl) { gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA), gl.BlendEquation(GL_MAX); };
  EXPECT_EQ(compareBlended("most", by(most)).drawsCulled, 0u);
}

/// In these, blending is not known to drop what is 1/1000 of a colour.
TEST(BlendedDraws, AreWholeInFramebuffersWithoutBytes) {
  for (const GLenum format : {GL_RGBA8, GL_RGB8, GL_RGBA16F, GL_RGBA16, GL_RGB10_A2}) {
    BlendedScene scene = tinted(1, 1);
    scene.prepare = [=](Gl gl) {
      std::array<GLuint, 2> images{};
      GLuint framebuffer = 0;
      gl.GenRenderbuffers(2, images.data()), gl.GenFramebuffers(1, &framebuffer);
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      for (const size_t i : {0u, 1u}) {
        gl.BindRenderbuffer(GL_RENDERBUFFER, images[i]);
        gl.RenderbufferStorage(GL_RENDERBUFFER, i == 0 ? format : GL_DEPTH_COMPONENT24, kSide, kSide);
        gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, i == 0 ? GL_COLOR_ATTACHMENT0 : GL_DEPTH_ATTACHMENT,
                                   GL_RENDERBUFFER, images[i]);
      }
      ASSERT_EQ(gl.CheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
    };
    const bool bytes = format == GL_RGBA8 || format == GL_RGB8;
    EXPECT_EQ(compareBlended("format", scene).drawsCulled > 0, bytes) << std::hex << format;
  }
}

/// gl_FrontColor becomes gl_Color.
TEST(BlendedDraws, ByColorsOfFixedFunction) {
  const ProgramMesh mesh = shells(5, 100);
  const auto culledWith = [&](GLubyte alpha, bool twoSided, const char* back) {
    GLuint program = 0;
    const std::vector<std::array<GLubyte, 4>> colors(mesh.positions.size(), {200, 120, 40, alpha});
    return compareFrames(
               "fixed_colors", 4,
               [&](Gl gl) {
                 program = makeProgram(gl,
                                       "void main() { gl_FrontColor = gl_Color; gl_BackColor = " +
                                           std::string(back) + "; gl_Position = ftransform(); }",
                                       "void main() { gl_FragColor = gl_Color; }");
               },
               [&](Gl gl, int frame) {
                 clear(gl);
                 gl.UseProgram(program);
                 if (twoSided) gl.Enable(GL_VERTEX_PROGRAM_TWO_SIDE);
                 gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
                 gl.MatrixMode(GL_PROJECTION), gl.LoadIdentity(), gl.Frustum(-0.2, 0.2, -0.2, 0.2, 0.5, 20);
                 gl.MatrixMode(GL_MODELVIEW), gl.LoadIdentity(), gl.Translatef(0.1f, 0, -4);
                 gl.Rotatef(7.0f * static_cast<float>(frame), 0.3f, 1, 0.2f);
                 gl.EnableClientState(GL_VERTEX_ARRAY), gl.EnableClientState(GL_COLOR_ARRAY);
                 gl.VertexPointer(3, GL_FLOAT, 0, mesh.positions.data());
                 gl.ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors.data());
                 gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, mesh.indices.data());
               },
               nullptr, {kSide, kSide})
        .drawsCulled;
  };
  EXPECT_GT(culledWith(255, false, "vec4(0.5)"), 0u);
  EXPECT_GT(culledWith(255, true, "gl_Color"), 0u);
  EXPECT_EQ(culledWith(255, true, "vec4(0.5)"), 0u);
  EXPECT_EQ(culledWith(254, false, "gl_Color"), 0u);
}

}  // namespace
}  // namespace gluray::test
