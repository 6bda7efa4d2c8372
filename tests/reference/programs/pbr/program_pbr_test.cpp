// VTK's physically based materials with textures, normal maps and environments, drawn by the real OpenGL and
// traced: the same colours and depths, also while tracing fails.
#include "gl/real/extensions.h"
#include "tests/reference/programs/pbr/pbr_stage.h"
#include "tests/reference/programs/program_mutants.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Normals = Surface::Normals;
using Lights = Surface::Lights;
using Environment = Surface::Environment;

struct PbrCase {
  const char* name;
  Surface surface;
  bool ball = true;
  PbrFilter filter = {};
};
void PrintTo(const PbrCase& c, std::ostream* out) { *out << c.name; }

const PbrCase kPbrCases[] = {
    {"textures", {.lights = Lights::pbr, .lightCount = 3, .pbrTextures = true}},
    {"textures_headlight", {.lights = Lights::pbrHeadlight, .pbrTextures = true}, false},
    {"textures_of_levels", {.lights = Lights::pbr, .pbrTextures = true}, true, {GL_LINEAR_MIPMAP_LINEAR}},
    {"textures_anisotropic",
     {.lights = Lights::pbr, .pbrTextures = true, .normalMap = true},
     true,
     {GL_LINEAR_MIPMAP_LINEAR, 4}},
    {"textures_anisotropic_nearest_level",
     {.lights = Lights::pbr, .pbrTextures = true},
     false,
     {GL_LINEAR_MIPMAP_NEAREST, 16}},
    {"textures_anisotropic_one_level", {.lights = Lights::pbr, .pbrTextures = true}, false, {GL_LINEAR, 2}},
    {"textures_on_triangles",
     {.normals = Normals::triangle, .lights = Lights::pbr, .pbrTextures = true},
     false},
    {"textures_and_vertex_colors", {.color = Color::vertex, .lights = Lights::pbr, .pbrTextures = true}},
    {"normal_map", {.lights = Lights::pbr, .lightCount = 2, .normalMap = true}, false},
    {"normal_map_of_levels",
     {.lights = Lights::pbrHeadlight, .normalMap = true},
     true,
     {GL_LINEAR_MIPMAP_NEAREST}},
    {"normal_map_of_sixteen_bits",
     {.lights = Lights::pbr, .lightCount = 2, .normalMap = true},
     false,
     {GL_LINEAR, 1, GL_RGBA16}},
    {"textures_and_normal_map", {.lights = Lights::pbr, .pbrTextures = true, .normalMap = true}},
    {"harmonics", {.lights = Lights::pbr, .environment = Environment::harmonics}},
    {"irradiance", {.lights = Lights::pbrHeadlight, .environment = Environment::cube}},
    {"everything",
     {.lights = Lights::pbr,
      .lightCount = 2,
      .pbrTextures = true,
      .normalMap = true,
      .environment = Environment::harmonics},
     true,
     {GL_LINEAR_MIPMAP_LINEAR}},
    {"recent_textures",
     {.lights = Lights::pbr, .lightCount = 2, .pbrTextures = true, .normalMap = true, .recent = true}},
    {"recent_harmonics", {.lights = Lights::pbr, .environment = Environment::harmonics, .recent = true}},
    {"recent_irradiance", {.lights = Lights::pbrHeadlight, .environment = Environment::cube, .recent = true}},
    {"recent_vertex_colors",
     {.color = Color::vertex, .lights = Lights::pbr, .pbrTextures = true, .recent = true}},
    {"recent_everything",
     {.lights = Lights::pbrPositional,
      .lightCount = 2,
      .pbrTextures = true,
      .normalMap = true,
      .environment = Environment::harmonics,
      .recent = true}},
    {"everything_by_irradiance",
     {.lights = Lights::pbr, .pbrTextures = true, .normalMap = true, .environment = Environment::cube},
     false},
};

void drawPbrCase(Gl gl, const PbrCase& c) {
  const ProgramMesh mesh = c.ball ? ball(24) : sheet(24);
  const GLuint program = makeProgram(gl, c.surface);
  upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  setAll(gl, program, perspectiveView(25), c.surface);
  setPbrInputs(gl, program, c.surface, c.filter);
  gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
}

class ProgramPbr : public testing::TestWithParam<PbrCase> {};

/// Draws that are traced. How Mesa filters anisotropically is known of its versions 22 and 23.
int tracedDraws(const PbrFilter& filter) {
  if (filter.anisotropy <= 1) return 1;
  const auto real = OsmesaContext::create(coreWish());
  const int mesa = gl::mesaVersionOf(real->real().GetString(GL_VERSION));
  return mesa >= 2200 && mesa < 2400 ? 1 : 0;
}

TEST_P(ProgramPbr, LooksLikeTheRealOne) {
  const Outcome o = expectSame(
      GetParam().name, [](Gl gl) { drawPbrCase(gl, GetParam()); }, tracedDraws(GetParam().filter),
      coreWish());
  size_t hit = 0;
  for (const float depth : o.expected.depths) hit += depth < 1;
  EXPECT_GT(hit, o.expected.depths.size() / 20) << "next to nothing is to be seen";
}

TEST_P(ProgramPbr, LooksLikeTheRealOneWhereTracingFails) {
  expectSameWhenTracingFails(
      GetParam().name, [](Gl gl) { drawPbrCase(gl, GetParam()); }, coreWish());
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramPbr, testing::ValuesIn(kPbrCases),
                         [](const auto& info) { return std::string(info.param.name); });

void expectRasterised(const char* name, const Surface& surface, const DrawProgram& change) {
  const auto draw = [&](Gl gl) {
    const ProgramMesh mesh = sheet(12);
    const GLuint program = makeProgram(gl, surface);
    upload(gl, mesh, program);
    beginFrame(gl);
    gl.UseProgram(program);
    setAll(gl, program, perspectiveView(25), surface);
    setPbrInputs(gl, program, surface);
    change(gl);
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  };
  expectSame(name, draw, 0, coreWish());
}

/// Units of base colour, material and emission.
TEST(ProgramPbrs, TexturesWithFactorsAboveOneAreLeftToTheRealOne) {
  for (const GLenum unit : {5u, 6u, 7u})
    expectRasterised("pbr_factor_above_one", {.lights = Lights::pbr, .pbrTextures = true}, [unit](Gl gl) {
      const GLfloat texel[4] = {1.5f, 1.2f, 1.1f, 1};
      gl.ActiveTexture(GL_TEXTURE0 + unit);
      gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16F, 1, 1, 0, GL_RGBA, GL_FLOAT, texel);
    });
}

TEST(ProgramPbrs, IncompleteEnvironmentsAreLeftToTheRealOne) {
  expectRasterised("pbr_incomplete", {.lights = Lights::pbr, .environment = Environment::cube}, [](Gl gl) {
    gl.ActiveTexture(GL_TEXTURE9);
    gl.TexImage2D(GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 2, GL_RGB16F, 1, 1, 0, GL_RGB, GL_FLOAT, nullptr);
  });
}

class PbrMutants : public testing::TestWithParam<PbrCase> {};

TEST_P(PbrMutants, AreNotTakenForTheOriginal) {
  const Surface& surface = GetParam().surface;
  expectMutantsSeen(
      GetParam().name, {{GL_VERTEX_SHADER, vertexText(surface)}, {GL_FRAGMENT_SHADER, fragmentText(surface)}},
      [&](Gl gl, GLuint program) {
        const ProgramMesh mesh = ball(12);
        const Upload up = upload(gl, mesh, program);
        beginFrame(gl);
        gl.UseProgram(program);
        setAll(gl, program, perspectiveView(25), surface);
        setPbrInputs(gl, program, surface);
        gl.BindVertexArray(up.array);
        gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
      },
      coreWish());
}

const PbrCase kPbrMutantCases[] = {
    {"pbr_textures",
     {.lights = Lights::pbr, .pbrTextures = true, .normalMap = true, .environment = Environment::harmonics}},
    {"pbr_irradiance", {.lights = Lights::pbrHeadlight, .environment = Environment::cube}},
    {"pbr_recent", {.lights = Lights::pbrPositional, .environment = Environment::harmonics, .recent = true}},
    {"pbr_recent_vertex_colors", {.color = Color::vertex, .lights = Lights::pbr, .recent = true}},
};
INSTANTIATE_TEST_SUITE_P(MoreCases, PbrMutants, testing::ValuesIn(kPbrMutantCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
