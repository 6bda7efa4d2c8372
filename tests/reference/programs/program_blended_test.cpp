// Surfaces and impostors of programs that are blended in the order of drawing, with and without depth writes.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/built_in/built_in_stage.h"
#include "tests/reference/programs/sent/sent_impostors.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <utility>

namespace gluray::test {
namespace {

struct BlendedCase {
  const char* name;
  GLenum source, destination;
  bool writesDepth;
  GLenum depthFunc = GL_LESS;
};
void PrintTo(const BlendedCase& c, std::ostream* out) { *out << c.name; }

const BlendedCase kBlendedCases[] = {
    {"over", GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, false},
    {"over_writing", GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, true},
    {"over_or_equal", GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, true, GL_LEQUAL},
    {"added", GL_SRC_ALPHA, GL_ONE, false},
    {"premultiplied", GL_ONE, GL_ONE_MINUS_SRC_ALPHA, false},
    {"replaced", GL_ONE, GL_ZERO, false},
};

void setBlendingOf(Gl gl, const BlendedCase& c) {
  gl.Enable(GL_BLEND), gl.BlendFunc(c.source, c.destination);
  gl.DepthMask(c.writesDepth), gl.DepthFunc(c.depthFunc);
}

class BlendedPrograms : public testing::TestWithParam<BlendedCase> {};

/// Programs that read gl_Vertex, among fixed function's surfaces, opaque and blended.
TEST_P(BlendedPrograms, OfBuiltInVerticesAreTraced) {
  const BlendedCase& c = GetParam();
  for (const Way way : {Way::clientElements, Way::immediate, Way::list})
    expectBuiltIns(
        std::string("blended-") + c.name + "-" + nameOf(way),
        [&](Gl gl) {
          const GLuint program = makeProgram(gl, kShaded.vertex, kShaded.fragment);
          const ProgramMesh round = ball(20), wavy = sheet(12);
          beginBuiltInFrame(gl);
          gl.PushMatrix(), gl.Translatef(0, 0, -0.6f);
          gl.Color4f(0.2f, 0.6f, 0.3f, 1), sendMesh(gl, wavy, way, false);
          gl.PopMatrix();
          setBlendingOf(gl, c);
          gl.UseProgram(program);
          gl.Color4f(0.9f, 0.4f, 0.1f, 0.4f), sendMesh(gl, round, way, false);
          gl.UseProgram(0);
          gl.Translatef(0.3f, 0, 0.3f), gl.Color4f(0.1f, 0.4f, 0.9f, 0.6f), sendMesh(gl, round, way, false);
          gl.UseProgram(program);
          gl.Rotatef(60, 1, 0, 0), gl.Color4f(0.8f, 0.8f, 0.2f, 0.3f), sendMesh(gl, wavy, way, false);
          gl.DepthMask(GL_TRUE);
        },
        4);
}

const char* const kClearVertex =
    "#version 150\nin vec3 vertexMC, normalMC; uniform mat4 mvp; uniform mat3 turn; out vec3 n;\n"
    "void main() { n = turn * normalMC; gl_Position = mvp * vec4(vertexMC, 1); }\n";
const char* const kClearFragment =
    "#version 150\nuniform vec3 tint; uniform float opacity; in vec3 n; out vec4 color;\n"
    "void main() { color = vec4(tint * abs(normalize(n).z), opacity); }\n";
const char* const kClearFamily =
    "[[family]]\nname = \"clear\"\nmatch.active = [\"vertexMC\", \"tint\"]\nvertex.position = \"vertexMC\"\n"
    "vertex.normal = \"normalMC\"\ntransform.clip_from_object = \"mvp\"\ntransform.normal_matrix = \"turn\"\n"
    "lights.two_sided = true\nlights.direction = [0, 0, 1]\nmaterial.diffuse_color = \"tint\"\n"
    "material.opacity = \"opacity\"\n";

void drawClear(Gl gl, GLuint program, const ProgramMesh& mesh, const glm::dvec3& at, const glm::vec3& tint,
               float opacity) {
  View view = perspectiveView(35);
  view.eyeFromObject = glm::translate(glm::dmat4(1), at) * view.eyeFromObject;
  setMat4(gl, program, "mvp", glm::mat4(view.clipFromEye * view.eyeFromObject));
  setMat3(gl, program, "turn", glm::mat3(view.eyeFromObject));
  setVec3(gl, program, "tint", tint), setFloat(gl, program, "opacity", opacity);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

/// Balls whose colours are multiplied by `light`, and a dark one over them.
void drawArrays(Gl gl, const BlendedCase& c, float light = 1) {
  const ProgramMesh mesh = ball(20);
  const GLuint program = makeProgram(gl, kClearVertex, kClearFragment);
  upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  drawClear(gl, program, mesh, {-0.5, 0, -0.5}, light * glm::vec3(0.3f, 0.9f, 0.5f), 1);
  setBlendingOf(gl, c);
  drawClear(gl, program, mesh, {0.4, 0.2, 0}, light * glm::vec3(0.9f, 0.3f, 0.2f), 0.5f);
  drawClear(gl, program, mesh, {0, -0.3, 0.3}, light * glm::vec3(0.2f, 0.4f, 1), 0.3f);
  drawClear(gl, program, mesh, {0.2, 0, -1}, light * glm::vec3(1, 1, 0.2f), 0.7f);
  if (light != 1) drawClear(gl, program, mesh, {0.1, 0, 0.6}, {0, 0, 0.1f}, 0.6f);
}

TEST_P(BlendedPrograms, OfArraysAreTraced) {
  for (const auto& [profile, wish] : {std::pair("", compatibleWish()), std::pair("core-", coreWish(4, 5))})
    expectBoth(
        std::string("blended-arrays-") + profile + GetParam().name, [](Gl gl) { drawArrays(gl, GetParam()); },
        4, wish, kProgramTolerance, kClearFamily);
}

struct FloatFormat {
  const char* name;
  GLenum color, depth;
};
constexpr FloatFormat kFloatFormats[] = {{"rgba16f", GL_RGBA16F, GL_DEPTH_COMPONENT24},
                                         {"rgba32f", GL_RGBA32F, GL_DEPTH_COMPONENT32},
                                         {"rgba32f-d32f", GL_RGBA32F, GL_DEPTH_COMPONENT32F}};

/// Floats are not clamped: colours above 1 show where something dark is blended over them.
TEST_P(BlendedPrograms, OfArraysAreTracedInFramebuffersOfFloats) {
  for (const FloatFormat& format : kFloatFormats)
    expectBoth(
        std::string("blended-") + format.name + "-" + GetParam().name,
        [&](Gl gl) {
          bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, format.color, format.depth);
          drawArrays(gl, GetParam(), 2.5f);
        },
        5, coreWish(), kProgramTolerance, kClearFamily);
}

TEST_P(BlendedPrograms, OfSentSpheresAreTraced) {
  const BlendedCase& c = GetParam();
  SentView look;
  look.opacity = 0.45f;
  const SentImpostors sent = manySpheres();
  expectBoth(
      std::string("blended-spheres-") + c.name,
      [&](Gl gl) {
        prepareSent(gl, sent, look);
        setBlendingOf(gl, c);
        drawSent(gl, sent);
      },
      1, compatibleWish(), kProgramTolerance, sentFamily(false, false));
}

/// Both sides of a stick's box cover its pixels: sticks are one fragment where one side is culled.
TEST_P(BlendedPrograms, OfSentSticksAreTracedWhereOneSideOfBoxesIsCulled) {
  const BlendedCase& c = GetParam();
  SentView look;
  look.opacity = 0.45f;
  const SentImpostors sent = manySticks();
  for (const bool cull : {false, true})
    expectBoth(
        std::string("blended-sticks-") + c.name + (cull ? "-culled" : ""),
        [&](Gl gl) {
          prepareSent(gl, sent, look);
          setBlendingOf(gl, c);
          if (cull) gl.Enable(GL_CULL_FACE);
          drawSent(gl, sent);
        },
        cull, compatibleWish(), kProgramTolerance, sentFamily(true, false));
}

INSTANTIATE_TEST_SUITE_P(Cases, BlendedPrograms, testing::ValuesIn(kBlendedCases),
                         [](const auto& info) { return std::string(info.param.name); });

/// One ball blended over the background, and what `more` draws with the program in use.
void expectClearBall(const std::string& name, int draws, const ContextWish& wish,
                     const std::function<void(Gl, const ProgramMesh&)>& more = {}) {
  expectBoth(
      name,
      [&](Gl gl) {
        const ProgramMesh mesh = ball(12);
        const GLuint program = makeProgram(gl, kClearVertex, kClearFragment);
        upload(gl, mesh, program);
        beginFrame(gl);
        gl.UseProgram(program);
        setBlendingOf(gl, kBlendedCases[0]);
        drawClear(gl, program, mesh, {0.4, 0.2, 0}, {0.9f, 0.3f, 0.2f}, 0.5f);
        if (more) more(gl, mesh);
      },
      draws, wish, kProgramTolerance, kClearFamily);
}

/// Where there is no fixed function the framebuffer's attachments have its bits.
TEST(BlendedProgram, InACoreProfileIsTraced) { expectClearBall("blended-core", 1, {}); }

/// What rounding takes from each of many thin layers in a framebuffer of half floats adds up.
TEST(BlendedProgram, InFramebuffersOfHalfFloatsAddsUpAsTheRealOpenGlRounds) {
  expectBoth(
      "blended-thin-layers",
      [](Gl gl) {
        bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, GL_RGBA16F, GL_DEPTH_COMPONENT24);
        const ProgramMesh mesh = ball(12);
        const GLuint program = makeProgram(gl, kClearVertex, kClearFragment);
        upload(gl, mesh, program);
        beginFrame(gl);
        gl.UseProgram(program);
        setBlendingOf(gl, kBlendedCases[0]);
        for (int i = 0; i < 120; ++i)
          drawClear(gl, program, mesh, {0, 0, 0.002 * i}, {0.9f, 0.8f, 0.7f}, 0.01f);
      },
      120, coreWish(), kProgramTolerance, kClearFamily);
}

/// Floats of other sizes, several samples, and reads that are clamped.
TEST(BlendedProgram, InOtherFramebuffersOfFloatsIsLeft) {
  const struct {
    const char* name;
    GLenum color;
    GLsizei samples;
  } kinds[] = {{"r11f", GL_R11F_G11F_B10F, 0}, {"samples", GL_RGBA16F, 4}};
  for (const auto& kind : kinds)
    expectBoth(
        std::string("blended-floats-") + kind.name,
        [&](Gl gl) {
          bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, kind.color, GL_DEPTH_COMPONENT24,
                             kind.samples);
          drawArrays(gl, kBlendedCases[0]);
          gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        },
        1, coreWish(), kProgramTolerance, kClearFamily);
}

/// Instances, and a draw that is repeated, are left to the real OpenGL.
TEST(BlendedProgram, RepeatedByInstancesIsLeft) {
  expectClearBall("blended-repeated", 1, compatibleWish(), [](Gl gl, const ProgramMesh& mesh) {
    gl.DrawElementsInstanced(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr, 3);
  });
}

}  // namespace
}  // namespace gluray::test
