// Surfaces of VTK 9.7 and f3d 4: a floor of the distribution of normals, colours raised to powers, unlit
// surfaces with base textures. Environments are in program_pbr_test.cpp.
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Lights = Surface::Lights;

struct RecentCase {
  const char* name;
  Surface surface;
  bool ball = true;
  void (*prepare)(Gl, GLuint program) = nullptr;
};
void PrintTo(const RecentCase& c, std::ostream* out) { *out << c.name; }

void overrideRecentColors(Gl gl, GLuint program) { setInteger(gl, program, "OverridesColor", 1); }
void smoothMetal(Gl gl, GLuint program) {
  setFloat(gl, program, "roughnessUniform", 0.05f), setFloat(gl, program, "metallicUniform", 1);
}
void withoutAmbient(Gl gl, GLuint program) { setFloat(gl, program, "ambientIntensity", 0); }

const RecentCase kRecentCases[] = {
    {"pbr", {.lights = Lights::pbr, .lightCount = 3, .recent = true}},
    {"pbr_smooth", {.lights = Lights::pbr, .lightCount = 3, .recent = true}, true, smoothMetal},
    {"pbr_headlight", {.lights = Lights::pbrHeadlight, .recent = true}},
    {"pbr_headlight_smooth", {.lights = Lights::pbrHeadlight, .recent = true}, true, smoothMetal},
    {"pbr_positional", {.lights = Lights::pbrPositional, .lightCount = 3, .recent = true}, false},
    {"pbr_vertex_colors", {.color = Color::vertex, .lights = Lights::pbr, .recent = true}},
    {"pbr_vertex_colors_overridden",
     {.color = Color::vertex, .lights = Lights::pbr, .recent = true},
     true,
     overrideRecentColors},
    {"pbr_mapped", {.color = Color::mapped, .lights = Lights::pbr, .recent = true}, false},
    {"pbr_cell", {.color = Color::cell, .lights = Lights::pbr, .overridable = false, .recent = true}, false},
    {"vertex", {.color = Color::vertex, .recent = true}},
    {"unlit", {.lights = Lights::none, .recent = true}},
    {"unlit_vertex", {.color = Color::vertex, .lights = Lights::none, .recent = true}},
    {"unlit_mapped", {.color = Color::mapped, .lights = Lights::none, .recent = true}, false},
    {"unlit_texture", {.lights = Lights::none, .actorTexture = true, .recent = true}, false},
    {"base_texture", {.lights = Lights::none, .baseTexture = true}, false},
    {"unlit_base_texture", {.lights = Lights::none, .recent = true, .baseTexture = true}, false},
    {"unlit_base_texture_and_vertex_colors",
     {.color = Color::vertex, .lights = Lights::none, .recent = true, .baseTexture = true},
     false,
     withoutAmbient},
};

void drawRecent(Gl gl, const RecentCase& c) {
  const ProgramMesh mesh = c.ball ? ball(24) : sheet(24);
  const GLuint program = makeProgram(gl, c.surface);
  upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  if (c.surface.color == Color::cell) cellColors(gl, mesh, 1), setInteger(gl, program, "textureC", 1);
  if (c.surface.color == Color::mapped) colorMap(gl, 3), setInteger(gl, program, "colortexture", 3);
  chequers(gl, 4);
  for (const char* sampler : {"actortexture", "albedoTex"}) setInteger(gl, program, sampler, 4);
  setAll(gl, program, perspectiveView(25), c.surface);
  if (c.prepare) c.prepare(gl, program);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

class ProgramRecent : public testing::TestWithParam<RecentCase> {};

TEST_P(ProgramRecent, LooksLikeTheRealOne) {
  expectBoth(
      GetParam().name, [](Gl gl) { drawRecent(gl, GetParam()); }, 1);
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramRecent, testing::ValuesIn(kRecentCases),
                         [](const auto& info) { return std::string(info.param.name); });

/// Where all normals face a far viewer, the floor alone decides how bright a smooth surface is.
TEST(ProgramRecents, TheDistributionHasAFloor) {
  const Surface surface{.lights = Lights::pbrHeadlight, .recent = true};
  const Outcome o = expectSame(
      "floor",
      [&](Gl gl) {
        const ProgramMesh mesh = sheet(24);
        const GLuint program = makeProgram(gl, surface);
        upload(gl, mesh, program);
        beginFrame(gl);
        gl.UseProgram(program);
        View far;
        far.eyeFromObject = glm::translate(glm::dmat4(1), {0, 0, -400});
        far.clipFromEye = glm::perspective(glm::radians(0.3), 4.0 / 3, 300.0, 500.0);
        setAll(gl, program, far, surface);
        setMat3(gl, program, "normalMatrix", glm::mat3(0.004f, 0, 0, 0, 0.004f, 0, 0, 0, 1));
        setFloat(gl, program, "roughnessUniform", 0.02f), setFloat(gl, program, "metallicUniform", 1);
        setVec3(gl, program, "lightColor0", glm::vec3(0.05f));
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
      },
      1);
  const uint32_t center = o.expected.colors[size_t{kProgramWidth} * (kProgramHeight / 2) + kProgramWidth / 2];
  const uint32_t blue = center >> 16 & 255;
  EXPECT_GT(blue, 40u) << "lit";
  EXPECT_LT(blue, 250u) << "not too bright to show the floor";
}

/// The texture does not change the ambient colours, which come from the vertices, too.
TEST(ProgramRecents, TexturesOfDiffuseVertexColorsAloneAreLeftToTheRealOne) {
  const RecentCase c{"base_texture_ambient",
                     {.color = Color::vertex, .lights = Lights::none, .recent = true, .baseTexture = true},
                     false};
  expectSame(
      c.name, [&](Gl gl) { drawRecent(gl, c); }, 0);
}

}  // namespace
}  // namespace gluray::test
