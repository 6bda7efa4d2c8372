// All kinds of programs that VTK builds for surfaces, drawn by the real OpenGL and traced: the same colours
// and depths, also while tracing fails.
#include "tests/reference/programs/program_stage.h"

#include <gtest/gtest.h>

namespace gluray::test {
namespace {

using Color = Surface::Color;
using Normals = Surface::Normals;
using Lights = Surface::Lights;

/// A kind of surface, and what a program does beside drawing it.
struct SurfaceCase {
  const char* name;
  Surface surface;
  bool ball = true, parallel = false;
  void (*prepare)(Gl, GLuint program) = nullptr;
};
void PrintTo(const SurfaceCase& c, std::ostream* out) { *out << c.name; }

void overrideColors(Gl gl, GLuint program) { setInteger(gl, program, "OverridesColor", 1); }
void cullBack(Gl gl, GLuint) { gl.Enable(GL_CULL_FACE); }
void cullFront(Gl gl, GLuint) { gl.Enable(GL_CULL_FACE), gl.CullFace(GL_FRONT); }
void clockwise(Gl gl, GLuint) { gl.FrontFace(GL_CW); }
void clockwiseCulled(Gl gl, GLuint) { gl.FrontFace(GL_CW), gl.Enable(GL_CULL_FACE); }
void setPlanes(Gl gl, GLuint program, int count) {
  const GLfloat planes[3][4] = {{0.3f, 0.2f, 1, 0.2f}, {-1, 0.5f, 0, 0.4f}, {1e30f, -1e30f, 1e30f, -1e30f}};
  gl.Uniform4fv(gl.GetUniformLocation(program, "clipPlanes"), 3, planes[0]);
  setInteger(gl, program, "numClipPlanes", count);
}
void onePlane(Gl gl, GLuint program) { setPlanes(gl, program, 1); }
void twoPlanes(Gl gl, GLuint program) { setPlanes(gl, program, 2); }
void invisibleInside(Gl gl, GLuint program) {
  onePlane(gl, program), setFloat(gl, program, "opacityUniformBF", 0);
}
void noPlanes(Gl gl, GLuint program) { setPlanes(gl, program, 0); }
void twoPlanesAndCulled(Gl gl, GLuint program) { setPlanes(gl, program, 2), gl.Enable(GL_CULL_FACE); }
void pushed(Gl gl, GLuint program) {
  setFloat(gl, program, "cOffset", 2), setFloat(gl, program, "cFactor", 2);
}
void pulled(Gl gl, GLuint program) { setFloat(gl, program, "cOffset", -400); }
void halfRange(Gl gl, GLuint) { gl.DepthRange(0.25, 0.5); }
void scissored(Gl gl, GLuint) { gl.Enable(GL_SCISSOR_TEST), gl.Scissor(60, 40, 70, 90); }
void setTcMatrix(Gl gl, GLuint program, const glm::mat4& m) { setMat4(gl, program, "tcMatrix", m); }
void unitTcMatrix(Gl gl, GLuint program) { setTcMatrix(gl, program, glm::mat4(1)); }
/// Turned, stretched, moved; halved by w.
void movedTcMatrix(Gl gl, GLuint program) {
  setTcMatrix(gl, program, glm::mat4(0.9f, 0.8f, 0, 0, -1.1f, 1.3f, 0, 0, 0, 0, 1, 0, 0.6f, -0.2f, 0, 2));
}
void noMaterial(Gl gl, GLuint program) {
  for (const char* name : {"ambientIntensity", "diffuseIntensity", "specularIntensity"})
    setFloat(gl, program, name, 0);
}
void bright(Gl gl, GLuint program) {
  setVec3(gl, program, "lightColor0", {5, 3, 2}), setFloat(gl, program, "ambientIntensity", 2);
}

const SurfaceCase kSurfaceCases[] = {
    {"uniform", {}},
    {"uniform_unlit", {.lights = Lights::none}},
    {"vertex", {.color = Color::vertex}},
    {"vertex_unlit", {.color = Color::vertex, .lights = Lights::none}},
    {"mapped", {.color = Color::mapped}, false},
    {"mapped_unlit", {.color = Color::mapped, .lights = Lights::none}, false},
    {"cell", {.color = Color::cell}},
    {"cell_unlit", {.color = Color::cell, .lights = Lights::none}},
    {"vertex_unlit_alone", {.color = Color::vertex, .lights = Lights::none, .overridable = false}},
    {"mapped_unlit_alone", {.color = Color::mapped, .lights = Lights::none, .overridable = false}, false},
    {"cell_unlit_alone", {.color = Color::cell, .lights = Lights::none, .overridable = false}},
    {"vertex_overridden", {.color = Color::vertex}, true, false, overrideColors},
    {"mapped_overridden", {.color = Color::mapped}, false, false, overrideColors},
    {"cell_overridden", {.color = Color::cell}, true, false, overrideColors},
    {"cell_normals", {.normals = Normals::cell}},
    {"cell_colors_and_normals", {.color = Color::cell, .normals = Normals::cell, .lightCount = 5}},
    {"triangle_normals", {.normals = Normals::triangle, .lightCount = 3}},
    {"triangle_normals_parallel", {.normals = Normals::triangle, .lightCount = 3}, false, true},
    {"headlight", {.lights = Lights::headlight}},
    {"headlight_parallel", {.lights = Lights::headlight}, true, true},
    {"headlight_triangle_normals", {.normals = Normals::triangle, .lights = Lights::headlight}},
    {"five_lights", {.lightCount = 5}},
    {"five_lights_parallel", {.lightCount = 5}, true, true},
    {"positional", {.lights = Lights::positional, .lightCount = 1}},
    {"positional_cone_and_direction", {.lights = Lights::positional, .lightCount = 3}, false},
    {"pbr", {.lights = Lights::pbr, .lightCount = 3}},
    {"pbr_vertex_colors", {.color = Color::vertex, .lights = Lights::pbr, .lightCount = 2}, false},
    {"pbr_triangle_normals", {.normals = Normals::triangle, .lights = Lights::pbr}},
    {"pbr_headlight", {.lights = Lights::pbrHeadlight}},
    {"pbr_headlight_parallel", {.lights = Lights::pbrHeadlight}, true, true},
    {"pbr_headlight_triangle_normals", {.normals = Normals::triangle, .lights = Lights::pbrHeadlight}},
    {"pbr_positional", {.lights = Lights::pbrPositional, .lightCount = 3}},
    {"back_faces", {.lightCount = 2}, true, false, cullFront},
    {"back_culled", {}, true, false, cullBack},
    {"clockwise", {.lightCount = 2}, true, false, clockwise},
    {"clockwise_culled", {}, true, false, clockwiseCulled},
    {"back_material", {.backMaterial = true}, true, false, cullFront},
    {"back_material_unlit", {.lights = Lights::none, .backMaterial = true}, true, false, cullFront},
    {"back_material_pbr", {.lights = Lights::pbr, .backMaterial = true}, true, false, cullFront},
    {"back_material_and_vertex_colors",
     {.color = Color::vertex, .lightCount = 2, .backMaterial = true, .clipPlanes = true},
     true,
     false,
     onePlane},
    {"back_material_and_vertex_colors_unlit",
     {.color = Color::vertex, .lights = Lights::none, .backMaterial = true, .clipPlanes = true},
     true,
     false,
     onePlane},
    {"back_material_invisible", {.backMaterial = true, .clipPlanes = true}, true, false, invisibleInside},
    {"back_material_open",
     {.lightCount = 2, .backMaterial = true, .clipPlanes = true},
     true,
     false,
     onePlane},
    {"clip_one", {.clipPlanes = true}, true, false, onePlane},
    {"clip_two", {.clipPlanes = true}, true, false, twoPlanes},
    {"clip_none", {.clipPlanes = true}, true, false, noPlanes},
    {"clip_two_culled", {.clipPlanes = true}, true, false, twoPlanesAndCulled},
    {"offset_pushed", {.depthOffset = true}, false, false, pushed},
    {"offset_pulled", {.depthOffset = true}, true, false, pulled},
    {"offset_none", {.depthOffset = true}},
    {"actor_texture", {.actorTexture = true}, false},
    {"actor_texture_and_vertex_colors", {.color = Color::vertex, .actorTexture = true}, false},
    {"mapped_9_3", {.color = Color::mapped, .colorTcoord = true}, false},
    {"mapped_9_3_unlit", {.color = Color::mapped, .lights = Lights::none, .colorTcoord = true}, false},
    {"mapped_9_3_and_texture", {.color = Color::mapped, .actorTexture = true, .colorTcoord = true}, false},
    {"tc_matrix_identity",
     {.color = Color::mapped, .colorTcoord = true, .tcoordMatrix = true},
     false,
     false,
     unitTcMatrix},
    {"tc_matrix",
     {.color = Color::mapped, .colorTcoord = true, .tcoordMatrix = true},
     false,
     false,
     movedTcMatrix},
    {"tc_matrix_of_both",
     {.color = Color::mapped, .actorTexture = true, .colorTcoord = true, .tcoordMatrix = true},
     false,
     false,
     movedTcMatrix},
    {"tc_matrix_of_texture", {.actorTexture = true, .tcoordMatrix = true}, false, false, movedTcMatrix},
    {"depth_range", {}, true, false, halfRange},
    {"scissor", {}, true, false, scissored},
    {"black", {}, true, false, noMaterial},
    {"too_bright", {}, true, false, bright},
};

void drawSurfaceCase(Gl gl, const SurfaceCase& c) {
  const ProgramMesh mesh = c.ball ? ball(24) : sheet(24);
  const GLuint program = makeProgram(gl, c.surface);
  upload(gl, mesh, program);
  beginFrame(gl);
  gl.UseProgram(program);
  if (c.surface.color == Color::cell) cellColors(gl, mesh, 1), setInteger(gl, program, "textureC", 1);
  if (c.surface.normals == Normals::cell) cellNormals(gl, mesh, 2), setInteger(gl, program, "textureN", 2);
  if (c.surface.color == Color::mapped) colorMap(gl, 3), setInteger(gl, program, "colortexture", 3);
  if (c.surface.actorTexture) chequers(gl, 4), setInteger(gl, program, "actortexture", 4);
  setAll(gl, program, c.parallel ? parallelView(25) : perspectiveView(25), c.surface);
  if (c.prepare) c.prepare(gl, program);
  gl.DrawRangeElements(GL_TRIANGLES, 0, static_cast<GLuint>(mesh.positions.size() - 1), mesh.count(),
                       GL_UNSIGNED_INT, nullptr);
}

class ProgramSurface : public testing::TestWithParam<SurfaceCase> {};

TEST_P(ProgramSurface, LooksLikeTheRealOne) {
  const Outcome o = expectSame(
      GetParam().name, [](Gl gl) { drawSurfaceCase(gl, GetParam()); }, 1);
  size_t hit = 0;
  for (const float depth : o.expected.depths) hit += depth < 1;
  EXPECT_GT(hit, o.expected.depths.size() / 20) << "next to nothing is to be seen";
}

TEST_P(ProgramSurface, LooksLikeTheRealOneWhereTracingFails) {
  expectSameWhenTracingFails(GetParam().name, [](Gl gl) { drawSurfaceCase(gl, GetParam()); });
}

std::string surfaceNameOf(const testing::TestParamInfo<SurfaceCase>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Cases, ProgramSurface, testing::ValuesIn(kSurfaceCases), surfaceNameOf);

/// The material's colours replace translucent ones but keep their opacity, so nothing is traced.
TEST(ProgramSurfaces, TranslucentColorsBeneathOthersShowThrough) {
  for (const Color color : {Color::vertex, Color::cell, Color::mapped}) {
    const Surface surface{.color = color};
    for (const ContextWish& wish : {ContextWish{}, ContextWish{kProgramWidth, kProgramHeight}})
      expectSame(
          "overridden_translucent",
          [&](Gl gl) {
            ProgramMesh mesh = sheet(10);
            for (uint32_t& c : mesh.colors) c = (c & 0xffffffu) | 0x80000000u;
            const GLuint program = makeProgram(gl, surface);
            upload(gl, mesh, program);
            beginFrame(gl);
            gl.UseProgram(program);
            if (color == Color::cell) cellColors(gl, mesh, 1), setInteger(gl, program, "textureC", 1);
            if (color == Color::cell)
              gl.BufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(4 * mesh.colors.size()),
                               mesh.colors.data());
            if (color == Color::mapped) colorMap(gl, 3), setInteger(gl, program, "colortexture", 3);
            if (color == Color::mapped)
              gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 10, 1, GL_RGBA, GL_UNSIGNED_BYTE, mesh.colors.data());
            setAll(gl, program, perspectiveView(25), surface);
            overrideColors(gl, program);
            gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
          },
          0, wish);
  }
}

/// A matrix with a different w at each vertex, and one with w = 0.
TEST(ProgramSurfaces, TexcoordMatricesThatDivideAreLeftToTheRealOne) {
  for (const float w : {1.0f, 0.0f}) {
    const SurfaceCase c{"tc_matrix_divides", {.actorTexture = true, .tcoordMatrix = true}, false};
    expectSame(
        c.name,
        [&](Gl gl) {
          SurfaceCase now = c;
          now.prepare = w == 0 ? [](Gl g, GLuint program) { setTcMatrix(g, program, glm::mat4(0)); }
                               : [](Gl g, GLuint program) {
                                   glm::mat4 m(1);
                                   m[0].w = 0.5f;
                                   setTcMatrix(g, program, m);
                                 };
          drawSurfaceCase(gl, now);
        },
        0);
  }
}

/// VTK users choose the names of property textures.
TEST(ProgramSurfaces, ATextureMayHaveAnyName) {
  const Surface surface{.actorTexture = true};
  const auto draw = [&](Gl gl, bool twice) {
    std::string fragment = fragmentText(surface);
    const std::string name = "actortexture";
    for (size_t at = fragment.find(name); at != std::string::npos; at = fragment.find(name, at))
      fragment.replace(at, name.size(), "bricks");
    if (twice) fragment.replace(fragment.find("texture(bricks"), 14, "0.5 * texture(bricks");
    const ProgramMesh mesh = sheet(24);
    const GLuint program = makeProgram(gl, vertexText(surface), fragment);
    upload(gl, mesh, program);
    beginFrame(gl);
    gl.UseProgram(program);
    chequers(gl, 4), setInteger(gl, program, "bricks", 4);
    setAll(gl, program, perspectiveView(25), surface);
    gl.DrawElements(GL_TRIANGLES, mesh.count(), GL_UNSIGNED_INT, nullptr);
  };
  expectBoth(
      "texture_named", [&](Gl gl) { draw(gl, false); }, 1);
  expectSame(
      "texture_named_otherwise", [&](Gl gl) { draw(gl, true); }, 0);
}

/// The kinds of contexts in which VTK runs.
class ProgramContext : public testing::TestWithParam<ContextWish> {};

TEST_P(ProgramContext, TracesTheSame) {
  const ContextWish& wish = GetParam();
  Surface surface{.color = Color::vertex, .lightCount = 5};
  if (!wish.core) surface.version = "#version 150 compatibility\n";
  if (wish.minor == 5) surface.version = "#version 450\n";
  const SurfaceCase c{"context", surface};
  expectSame(
      "context", [&](Gl gl) { drawSurfaceCase(gl, c); }, 1, wish);
  expectSameWhenTracingFails(
      "context", [&](Gl gl) { drawSurfaceCase(gl, c); }, wish);
}

INSTANTIATE_TEST_SUITE_P(Kinds, ProgramContext,
                         testing::Values(coreWish(3, 2), coreWish(3, 3), coreWish(4, 5),
                                         ContextWish{kProgramWidth, kProgramHeight}));

}  // namespace
}  // namespace gluray::test
