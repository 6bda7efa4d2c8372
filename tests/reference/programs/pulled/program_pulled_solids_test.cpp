// Spheres and tubes of programs that pull vertices from buffer textures, against the real OpenGL.
#include "tests/reference/layers/summer.h"
#include "tests/reference/programs/program_mutants.h"
#include "tests/reference/programs/pulled/pulled_stage.h"

#include <gtest/gtest.h>

#include <ostream>

namespace gluray::test {
namespace {

struct PulledSolidCase {
  const char* name;
  PulledKind kind;
  PulledSurface surface;
  PulledWay way;
  float pixels = 9;
  bool parallel = false;
  int draws = 1;
};
void PrintTo(const PulledSolidCase& c, std::ostream* out) { *out << c.name; }

PulledWay besideOthers(PulledWay way) {
  way.pointsBefore = 5, way.verticesBefore = 6, way.cellsBefore = 3, way.trianglesBefore = 2;
  return way;
}
const PulledWay kBesideOthers = besideOthers({}), kQuads = besideOthers({.quads = true});

const PulledSurface kPointColors{.color = PulledColor::points};
const PulledSurface kCellColors{.color = PulledColor::cells};
const PulledSurface kTexels{.scalars = false};
const PulledSurface kTexelPoints{.color = PulledColor::points, .scalars = false};
const PulledSurface kTexelCells{
    .color = PulledColor::cells, .normals = PulledNormals::none, .scalars = false};
const PulledSurface kWithoutNormals{.normals = PulledNormals::none, .lights = PulledLights::positional};
const PulledSurface kClipped{.color = PulledColor::points, .clipPlanes = true};
const PulledSurface kMapped{.color = PulledColor::mapped, .lights = PulledLights::headlight};

const PulledSolidCase kPulledSolidCases[] = {
    {"spheres", PulledKind::vertices, {.lightCount = 2}, {}},
    {"spheres_parallel", PulledKind::vertices, kWithoutNormals, kBesideOthers, 12.5f, true},
    {"spheres_of_point_colors", PulledKind::corners, kPointColors, kBesideOthers},
    {"spheres_of_cell_colors", PulledKind::vertices, kCellColors, kBesideOthers},
    {"spheres_of_ends", PulledKind::ends, kCellColors, kBesideOthers},
    {"spheres_of_corners", PulledKind::corners, kCellColors, kBesideOthers},
    {"spheres_of_corners_of_quads", PulledKind::corners, kCellColors, kQuads},
    {"spheres_of_texels", PulledKind::ends, kTexelPoints, kBesideOthers, 7},
    {"spheres_of_texel_cells", PulledKind::corners, kTexelCells, kQuads, 7},
    {"spheres_unlit", PulledKind::vertices, kPointColors, {.lit = false}},
    {"spheres_clipped", PulledKind::vertices, kClipped, kBesideOthers},
    {"spheres_mapped", PulledKind::vertices, kMapped, kBesideOthers},
    {"spheres_indexed", PulledKind::vertices, kPointColors, {.pointsBefore = 4, .indexed = true}},
    {"tubes", PulledKind::lines, {.lightCount = 2}, {}},
    {"tubes_parallel", PulledKind::lines, kWithoutNormals, kBesideOthers, 6.5f, true},
    {"tubes_of_point_colors", PulledKind::lines, kPointColors, kBesideOthers, 11},
    {"tubes_of_cell_colors", PulledKind::lines, kCellColors, kBesideOthers, 5},
    {"tubes_of_cells_of_two", PulledKind::lines, kCellColors, kQuads, 5},
    {"tubes_are_lit", PulledKind::lines, {}, {.lit = false}},
    {"tubes_clipped", PulledKind::lines, kClipped, kBesideOthers},
    {"tubes_mapped", PulledKind::lines, kMapped, kBesideOthers},
    {"tubes_of_texels", PulledKind::lines, kTexels, kBesideOthers},
    {"tubes_of_texel_cells", PulledKind::lines, kTexelCells, kQuads},
    // All of them have the colour of point 0 there.
    {"tubes_of_texel_points", PulledKind::lines, kTexelPoints, {}, 9, false, 0},
};

View viewOf(const PulledSolidCase& c) { return c.parallel ? parallelView(35) : perspectiveView(35); }

ProgramMesh solidBowl() {
  ProgramMesh mesh = ball(8);
  mesh.indices.resize(mesh.indices.size() / 6 * 3);
  return mesh;
}

/// Draws a case after `change` of its program's uniforms.
void drawSolidCase(Gl gl, const PulledSolidCase& c, const std::function<void(Gl, GLuint)>& change = {}) {
  beginFrame(gl);
  const GLuint program = makeProgram(gl, c.surface);
  const PulledMesh mesh(gl, solidBowl(), c.way, c.surface.scalars);
  mesh.set(gl, program, viewOf(c), c.surface);
  if (change) change(gl, program);
  mesh.drawSolids(gl, program, c.kind, viewOf(c), c.pixels);
}

class PulledSolids : public testing::TestWithParam<PulledSolidCase> {};

TEST_P(PulledSolids, AreTraced) {
  const PulledSolidCase& c = GetParam();
  expectBoth(
      std::string("pulled_") + c.name, [&](Gl gl) { drawSolidCase(gl, c); }, c.draws);
}

INSTANTIATE_TEST_SUITE_P(All, PulledSolids, testing::ValuesIn(kPulledSolidCases),
                         [](const auto& info) { return std::string(info.param.name); });

/// Two cases, the first of spheres, the other of tubes.
const PulledSolidCase kSomeSpheres{"", PulledKind::vertices, kCellColors, kBesideOthers};
const PulledSolidCase kSomeTubes{"", PulledKind::lines, kCellColors, kBesideOthers, 6};

TEST(PulledSolid, AreDrawnByTheProgramOfTheirSurface) {
  const auto draw = [](Gl gl) {
    beginFrame(gl);
    const GLuint program = makeProgram(gl, kCellColors);
    const PulledMesh mesh(gl, solidBowl(), kBesideOthers, true);
    const View view = perspectiveView(35);
    mesh.set(gl, program, view, kCellColors);
    mesh.draw(gl);
    // Of different sizes: which of several equal spheres is seen is a matter of rounding.
    mesh.drawSolids(gl, program, PulledKind::corners, view, 10);
    mesh.drawSolids(gl, program, PulledKind::lines, view, 3);
    mesh.drawSolids(gl, program, PulledKind::vertices, view, 7);
    mesh.drawSolids(gl, program, PulledKind::ends, view, 5);
    mesh.set(gl, program, view, kCellColors);  // the surface's again, whose edges are not painted
    mesh.draw(gl);
  };
  expectBoth("pulled_mixed", draw, 6);
}

/// Translucent ones, added up in any order.
TEST(PulledSolid, AreSummed) {
  for (const PulledSolidCase& c :
       {PulledSolidCase{"spheres", PulledKind::corners, kCellColors, kQuads, 8},
        PulledSolidCase{"spheres_of_texels", PulledKind::ends, kTexelPoints, kBesideOthers, 7},
        PulledSolidCase{"tubes", PulledKind::lines, kPointColors, kBesideOthers, 6},
        PulledSolidCase{"tubes_of_texels", PulledKind::lines, kTexelCells, kQuads, 5}})
    expectBoth(
        std::string("pulled_summed_") + c.name,
        [&](Gl gl) {
          Summer summer(gl);
          PulledSurface surface = c.surface;
          surface.summed = true;
          PulledWay way = c.way;
          way.opacity = 0.4f;
          const GLuint program = makeProgram(gl, surface);
          const PulledMesh mesh(gl, solidBowl(), way, surface.scalars);
          summer.last = [&] {
            mesh.set(gl, program, viewOf(c), surface);
            mesh.drawSolids(gl, program, c.kind, viewOf(c), c.pixels);
          };
          summer.frame({Layer{.mesh = ball(16), .opacity = 1}});
        },
        2);
}

TEST(PulledSolid, WithOtherUniformsIsRasterised) {
  for (const PulledSolidCase& c : {kSomeSpheres, kSomeTubes})
    for (const auto& [name, value] : {std::pair{"vertex_pass", 1}, {"vertexIdOffset", 3}})
      expectSame(
          std::string("pulled_solid_other_") + name,
          [&, n = name, v = value](Gl gl) {
            drawSolidCase(gl, c, [&](Gl g, GLuint p) { setInteger(g, p, n, v); });
          },
          0);
  const auto picking = [](Gl gl, GLuint program) { setInteger(gl, program, "pointPicking", 1); };
  expectSame(
      "pulled_picking", [&](Gl gl) { drawSolidCase(gl, kSomeSpheres, picking); }, 0);
}

TEST(PulledSolid, IsRasterisedIfItsViewportIsAnother) {
  const auto half = [](Gl gl, GLuint program) {
    gl.Uniform4f(gl.GetUniformLocation(program, "viewportDimensions"), 0, 0, kProgramWidth / 2,
                 kProgramHeight);
  };
  const Outcome outcome = expectSame(
      "pulled_tubes_viewport", [&](Gl gl) { drawSolidCase(gl, kSomeTubes, half); }, 0);
  EXPECT_EQ(outcome.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::programValue)], 1u);
}

TEST(PulledSolid, FollowsTheViewport) {
  const auto draw = [](Gl gl) {
    const auto small = [](Gl g, GLuint program) {
      g.Viewport(20, 10, kProgramWidth / 2, kProgramHeight / 2);
      g.Uniform4f(g.GetUniformLocation(program, "viewportDimensions"), 20, 10, kProgramWidth / 2,
                  kProgramHeight / 2);
    };
    drawSolidCase(gl, kSomeTubes, small);
    gl.Viewport(0, 0, kProgramWidth, kProgramHeight);
  };
  expectSame("pulled_tubes_small", draw, 1);
}

TEST(PulledSolid, IsRasterisedIfItIsOnePixelWide) {
  PulledSolidCase thin = kSomeTubes;
  thin.pixels = 1;
  const Outcome outcome = expectSame(
      "pulled_tubes_thin", [&](Gl gl) { drawSolidCase(gl, thin); }, 0);
  EXPECT_EQ(outcome.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::lines)], 1u);
}

/// Draws a case, and then the same points or lines flat.
void drawRoundAndFlat(Gl gl, const PulledSolidCase& c) {
  beginFrame(gl);
  const GLuint program = makeProgram(gl, c.surface);
  const PulledMesh mesh(gl, solidBowl(), c.way, c.surface.scalars);
  mesh.set(gl, program, viewOf(c), c.surface);
  mesh.drawSolids(gl, program, c.kind, viewOf(c), c.pixels);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  setInteger(gl, program, "renderPointsAsSpheres", 0), setInteger(gl, program, "renderLinesAsTubes", 0);
  const bool lines = c.kind == PulledKind::lines;
  gl.DrawArraysInstanced(lines ? GL_TRIANGLES : GL_POINTS, c.way.verticesBefore, lines ? 60 : 30, 1);
}

TEST(PulledSolid, IsFlatUnlessItsUniformsMakeItRound) {
  for (const PulledSolidCase& c : {kSomeSpheres, kSomeTubes}) {
    const Outcome outcome = expectSame(
        "pulled_flat_lines_and_points", [&](Gl gl) { drawRoundAndFlat(gl, c); }, 1);
    const auto reason = c.kind == PulledKind::lines ? gl::Reason::lines : gl::Reason::points;
    EXPECT_EQ(outcome.statistics.rasterisedBecause[static_cast<size_t>(reason)], 1u);
  }
}

TEST(PulledSolid, FlatLinesAndPointsBecomeSolidsBySettings) {
  Settings settings = TracedContext::tracing();
  settings.lines.look = LineLook::tubes, settings.points.look = PointLook::spheres;
  for (const PulledSurface& surface : {kCellColors, kPointColors, kWithoutNormals, kTexelCells})
    for (const PulledKind kind :
         {PulledKind::vertices, PulledKind::ends, PulledKind::corners, PulledKind::lines}) {
      const TracedContext traced(coreWish(), settings);
      drawRoundAndFlat(traced.gl(), {"", kind, surface, kQuads});
      traced.gl().Finish();
      EXPECT_EQ(traced.context().counts.statistics.drawsTraced, 2u) << static_cast<int>(kind);
    }
}

TEST(PulledSolid, DoesNotChangeSurfacesBesideIt) {
  const auto draw = [](Gl gl) {  // round lines and points alone, but the actor's other cells are triangles
    beginFrame(gl);
    const GLuint program = makeProgram(gl, kPointColors);
    const PulledMesh mesh(gl, solidBowl(), {}, true);
    mesh.set(gl, program, perspectiveView(35), kPointColors);
    setInteger(gl, program, "renderPointsAsSpheres", 1), setInteger(gl, program, "renderLinesAsTubes", 1);
    setInteger(gl, program, "edgeVisibility", 1);  // edges would be round
    mesh.draw(gl);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    setInteger(gl, program, "edgeVisibility", 0);
    mesh.draw(gl);
  };
  const Outcome outcome = expectSame("pulled_beside_solids", draw, 1);
  EXPECT_EQ(outcome.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::programValue)], 1u);
}

class PulledSolidMutants : public testing::TestWithParam<PulledSolidCase> {};

TEST_P(PulledSolidMutants, AreNotTakenForTheOriginal) {
  const PulledSolidCase& c = GetParam();
  expectMutantsSeen(
      std::string("pulled_solid_") + c.name,
      {{GL_VERTEX_SHADER, pulledVertexText(c.surface)}, {GL_FRAGMENT_SHADER, pulledFragmentText(c.surface)}},
      [&](Gl gl, GLuint program) {
        beginFrame(gl);
        const PulledMesh mesh(gl, solidBowl(), c.way, c.surface.scalars);
        mesh.set(gl, program, viewOf(c), c.surface);
        mesh.drawSolids(gl, program, c.kind, viewOf(c), c.pixels);
      });
}

/// Label `program`: scripts/test --all.
INSTANTIATE_TEST_SUITE_P(
    MoreCases, PulledSolidMutants,
    testing::Values(PulledSolidCase{"spheres", PulledKind::ends, kCellColors, kQuads},
                    PulledSolidCase{"spheres_of_texels", PulledKind::corners, kTexelPoints, kBesideOthers},
                    PulledSolidCase{"tubes", PulledKind::lines, kPointColors, kBesideOthers},
                    PulledSolidCase{"tubes_of_texels", PulledKind::lines, kTexelCells, kQuads}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
