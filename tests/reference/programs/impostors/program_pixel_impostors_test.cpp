// Beads and tubes other than VTK's: the keys of the section [impostors] of family files about points and
// lines sized in pixels, each tested by a program that computes exactly that.
#include "tests/reference/framebuffer.h"
#include "tests/reference/programs/impostors/own_impostors.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

const char* const kPixelImpostorsVertex =
    "#version 150\nin vec3 place, paint; uniform mat4 projection, modelview; out vec3 eye, tint;\n"
    "void main() { eye = (modelview * vec4(place, 1)).xyz; tint = paint;\n"
    "  gl_Position = projection * vec4(eye, 1); }\n";

const char* const kTubeGeometry =
    "#version 150\nlayout(lines) in; layout(triangle_strip, max_vertices = 4) out;\n"
    "in vec3 eye[], tint[]; uniform vec2 wide; out vec3 at, color, aside, out_;\n"
    "void main() { vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;\n"
    "  vec2 d = b.xy / b.w - a.xy / a.w; float l = length(d); d /= l;\n"
    "  vec2 n = vec2(-d.y, d.x), grow = 0.25 * max(0.0, length(wide) - l) * d * b.w;\n"
    "  vec3 o = normalize(cross(normalize(eye[1] - eye[0]), vec3(n, 0)));\n"
    "  for (int j = 0; j < 4; ++j) { int i = j / 2; float s = j % 2 == 0 ? 1 : -1; vec4 p = "
    "gl_in[i].gl_Position;\n"
    "    p.xy += (i == 0 ? -grow : grow) + 0.5 * s * wide * n * p.w;\n"
    "    at = eye[i], color = tint[i], aside = vec3(s * n, 0), out_ = o * sign(o.z);\n"
    "    gl_Position = p; EmitVertex(); } }\n";

const std::string kPixelImpostorsFragmentHead =
    "#version 150\nuniform float bulge, pole, bias; uniform int ortho; uniform vec3 sun; out vec4 pixel;\n"
    "void show(vec3 n, vec3 base, float thick) { float z = gl_FragCoord.z;\n"
    "  z = ortho != 0 ? z + thick * bulge * pole : pole + (z - pole) / (1.0 - thick * bulge);\n"
    "  gl_FragDepth = z + bias / 65000.0;\n"
    "  pixel = vec4(base * (0.2 + 0.8 * max(dot(n, -sun), 0.0)), 1); }\n";
const char* const kTubeFragment =
    "in vec3 at, color, aside, out_;\n"
    "void main() { float thick = sqrt(clamp(1.0 - dot(aside, aside), 0.0, 1.0));\n"
    "  show(normalize(aside + thick * out_), color + 0.0 * at, thick / clamp(out_.z, 0.5, 1.0)); }\n";
const char* const kBeadFragment =
    "in vec3 eye, tint;\n"
    "void main() { vec2 p = vec2(2, -2) * gl_PointCoord + vec2(-1, 1); float q = dot(p, p);\n"
    "  if (q > 1.0) discard; float thick = sqrt(1.0 - q); show(vec3(p, thick), tint + 0.0 * eye, thick); }\n";

const std::string kFamily =
    kOwnFamily +
    "impostors.bulge = \"bulge\"\nimpostors.bulge_depth = \"pole\"\nimpostors.depth_bias = \"bias\"\n";
const std::string kTubeFamily =
    "match.geometry_shader = true\nimpostors.shape = \"tubes\"\nimpostors.size = \"wide\"\nimpostors.grows = "
    "true\n";
const std::string kBeadFamily = "impostors.shape = \"beads\"\n";

struct PixelImpostorCase {
  const char* name;
  bool tubes, parallel;
  float pixels, bias = 0;
  int numbers = 0;  // of an index array
};
void PrintTo(const PixelImpostorCase& c, std::ostream* out) { *out << c.name; }

const PixelImpostorCase kPixelImpostorCases[] = {
    {"tubes", true, false, 6},
    {"tubes_parallel", true, true, 5.5f, -300},
    {"tubes_by_number", true, false, 11, 0, 41},  // the last one has no partner
    {"beads", false, false, 9},
    {"beads_parallel", false, true, 12.5f, -300},
    {"beads_by_number", false, false, 5, 0, 33},
};

void setLook(Gl gl, GLuint program, const PixelImpostorCase& c, const View& view) {
  lookAtImpostors(gl, program, view, c.parallel);
  const double zz = view.clipFromEye[2][2];
  setFloat(gl, program, "bulge", static_cast<float>(c.pixels / (kProgramWidth * view.clipFromEye[0][0])));
  setFloat(gl, program, "pole", static_cast<float>(c.parallel ? zz : 0.5 - 0.5 * zz));
  setFloat(gl, program, "bias", c.bias);
  gl.Uniform2f(gl.GetUniformLocation(program, "wide"), 2 * c.pixels / kProgramWidth,
               2 * c.pixels / kProgramHeight);
  gl.PointSize(c.pixels);
}

GLuint drawPixelImpostorCase(Gl gl, const PixelImpostorCase& c) {
  const GLuint program =
      linkImpostors(gl, kPixelImpostorsVertex, c.tubes ? kTubeGeometry : "",
                    kPixelImpostorsFragmentHead + (c.tubes ? kTubeFragment : kBeadFragment));
  placeImpostors(gl, program);
  beginFrame(gl);
  gl.UseProgram(program);
  setLook(gl, program, c, c.parallel ? parallelView(35) : perspectiveView(35));
  const GLenum mode = c.tubes ? GL_LINES : GL_POINTS;
  if (!c.numbers) return gl.DrawArrays(mode, 4, kImpostors - 4), program;
  std::vector<GLushort> numbers;
  for (int i = 0; i < c.numbers; ++i) numbers.push_back(static_cast<GLushort>(7 * i % kImpostors));
  drawNumbered(gl, mode, numbers);
  return program;
}

std::string familyOf(const PixelImpostorCase& c) { return kFamily + (c.tubes ? kTubeFamily : kBeadFamily); }

class ProgramPixelImpostors : public testing::TestWithParam<PixelImpostorCase> {};

TEST_P(ProgramPixelImpostors, AreWhatTheProgramComputes) {
  const PixelImpostorCase& c = GetParam();
  expectBoth(
      std::string("pixels_") + c.name, [&](Gl gl) { drawPixelImpostorCase(gl, c); }, 1, coreWish(),
      kProgramTolerance, familyOf(c));
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramPixelImpostors, testing::ValuesIn(kPixelImpostorCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ProgramPixelImpostor, TheirSizeIsThatOfTheirDraw) {
  const PixelImpostorCase beads = kPixelImpostorCases[3];
  expectBoth(
      "pixels_sizes",
      [&](Gl gl) {
        drawPixelImpostorCase(gl, beads);
        gl.PointSize(20);
        gl.DrawArrays(GL_POINTS, 0, 4);
        gl.PointSize(2);
      },
      2, coreWish(), kProgramTolerance, familyOf(beads));
}

uint64_t rasterisedFor(gl::Reason reason, const Outcome& outcome) {
  return outcome.statistics.rasterisedBecause[static_cast<size_t>(reason)];
}

/// Mesa gives multisampled points the coordinates of positions beside their pixels' centres.
TEST(ProgramPixelImpostor, MultisampledPointsHaveTheCoordinatesThatTheRealOpenGlGivesThem) {
  const PixelImpostorCase beads = kPixelImpostorCases[3];
  const auto draw = [&](Gl gl) {
    bindNewFramebuffer(gl, {kProgramWidth, kProgramHeight}, GL_RGBA8, GL_DEPTH_COMPONENT24, 4);
    // Of all viewports, where there are several.
    gl.Scissor(0, 0, kProgramWidth, kProgramHeight), gl.Enable(GL_SCISSOR_TEST);
    drawPixelImpostorCase(gl, beads);
    gl.BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl.BlitFramebuffer(0, 0, kProgramWidth, kProgramHeight, 0, 0, kProgramWidth, kProgramHeight,
                       GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  };
  for (const ContextWish& wish : {coreWish(), coreWish(4, 5)})
    expectSame("pixels_multisampled", draw, 1, wish, kProgramTolerance, familyOf(beads));
}

TEST(ProgramPixelImpostor, UnderAReversedDepthTestAreLeftToTheRealOpenGl) {
  for (const PixelImpostorCase& c : {kPixelImpostorCases[0], kPixelImpostorCases[3]}) {
    const auto draw = [&](Gl gl) {
      const GLuint program = drawPixelImpostorCase(gl, c);
      gl.DepthFunc(GL_GREATER);
      gl.UseProgram(program);
      gl.DrawArrays(c.tubes ? GL_LINES : GL_POINTS, 4, kImpostors - 4);
    };
    const Outcome outcome = expectSame(std::string("pixels_reversed_") + c.name, draw, 1, coreWish(),
                                       kProgramTolerance, familyOf(c));
    EXPECT_EQ(rasterisedFor(gl::Reason::reversedDepth, outcome), 1u) << c.name;
  }
}

TEST(ProgramPixelImpostor, PointsHaveNoFacesToBeCulled) {
  const PixelImpostorCase beads = kPixelImpostorCases[3];
  for (const GLenum face : {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK}) {
    expectSame(
        "pixels_culled_points",
        [&](Gl gl) {
          gl.Enable(GL_CULL_FACE), gl.CullFace(face);
          drawPixelImpostorCase(gl, beads);
        },
        1, coreWish(), kProgramTolerance, familyOf(beads));
  }
}

TEST(ProgramPixelImpostor, TheViewerTurnsAndNothingIsBuilt) {
  const PixelImpostorCase tubes = kPixelImpostorCases[0];
  const Outcome outcome = expectSame(
      "pixels_turned",
      [&](Gl gl) {
        const GLuint program = drawPixelImpostorCase(gl, tubes);
        for (int i = 0; i < 5; ++i) {
          gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
          setLook(gl, program, tubes, perspectiveView(35 + 20 * i));
          gl.DrawArrays(GL_LINES, 4, kImpostors - 4);
        }
      },
      6, coreWish(), kProgramTolerance, familyOf(tubes));
  EXPECT_EQ(outcome.statistics.meshesBuilt, 1u);
}

TEST(ProgramPixelImpostor, WhatIsCulledHasAnotherProjectionOrIsNoSpriteIsLeftToTheRealOpenGl) {
  const PixelImpostorCase tubes = kPixelImpostorCases[0], beads = kPixelImpostorCases[3];
  expectSame(
      "pixels_culled", [&](Gl gl) { gl.Enable(GL_CULL_FACE), drawPixelImpostorCase(gl, tubes); }, 0,
      coreWish(), kProgramTolerance, familyOf(tubes));
  expectSame(
      "pixels_strip",
      [&](Gl gl) {
        drawPixelImpostorCase(gl, tubes);
        gl.DrawArrays(GL_LINE_STRIP, 0, 9);
      },
      1, coreWish(), kProgramTolerance, familyOf(tubes));
  expectSame(
      "pixels_lower_left",
      [&](Gl gl) {
        gl.PointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, GL_LOWER_LEFT);
        drawPixelImpostorCase(gl, beads);
      },
      0, coreWish(), kProgramTolerance, familyOf(beads));
  PixelImpostorCase wrong = beads;
  wrong.parallel = true;
  expectSame(
      "pixels_other_projection",
      [&](Gl gl) {
        const GLuint program = drawPixelImpostorCase(gl, wrong);
        setMat4(gl, program, "projection", glm::mat4(perspectiveView(35).clipFromEye));
        gl.DrawArrays(GL_POINTS, 0, 4);
      },
      1, coreWish(), kProgramTolerance, familyOf(beads));
}

}  // namespace
}  // namespace gluray::test
