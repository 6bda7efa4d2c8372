// Programs that pull vertices from buffer textures, against the real OpenGL.
#include "tests/reference/programs/program_mutants.h"
#include "tests/reference/programs/pulled/pulled_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <ostream>

namespace gluray::test {
namespace {

struct PulledCase {
  const char* name;
  PulledSurface surface;
  PulledWay way;
  int draws = 1;
};
void PrintTo(const PulledCase& c, std::ostream* out) { *out << c.name; }

PulledWay inSharedBuffers(PulledWay way) {
  way.pointsBefore = 5, way.verticesBefore = 6, way.cellsBefore = 3, way.trianglesBefore = 2,
  way.flagsBefore = 4;
  return way;
}
const PulledWay kSharedBuffers = inSharedBuffers({});

const PulledCase kPulledCases[] = {
    {"material", {.lightCount = 2}, {}},
    {"texels", {.lights = PulledLights::headlight, .scalars = false}, kSharedBuffers},
    {"points", {.color = PulledColor::points, .lights = PulledLights::headlight}, kSharedBuffers},
    {"cells", {.color = PulledColor::cells, .normals = PulledNormals::cells}, kSharedBuffers},
    {"texel_cells",
     {.color = PulledColor::cells, .normals = PulledNormals::cells, .scalars = false},
     kSharedBuffers},
    {"quads",
     {.color = PulledColor::cells, .normals = PulledNormals::cells},
     inSharedBuffers({.quads = true})},
    {"quads_by_points", {.color = PulledColor::points}, inSharedBuffers({.quads = true})},
    {"flat",
     {.normals = PulledNormals::none, .lights = PulledLights::positional, .lightCount = 3},
     kSharedBuffers},
    {"indexed", {.color = PulledColor::points}, {.pointsBefore = 4, .indexed = true}},
    {"indexed_cells", {.color = PulledColor::cells}, {.indexed = true}, 0},
    {"mapped", {.color = PulledColor::mapped, .lights = PulledLights::headlight}, kSharedBuffers},
    {"textured", {.color = PulledColor::mapped, .textured = true}, kSharedBuffers},
    {"unlit", {.color = PulledColor::points, .lights = PulledLights::none}, {}},
    {"unlit_now", {.color = PulledColor::cells}, inSharedBuffers({.quads = true, .lit = false})},
    {"unlit_material", {.lights = PulledLights::positional}, {.lit = false}},
    {"edges", {}, {.edges = true}},
    {"flagged_edges",
     {.color = PulledColor::cells},
     inSharedBuffers({.edges = true, .flagged = true, .edgeOpacity = 0.6f})},
    {"edges_of_quads",
     {.color = PulledColor::cells, .normals = PulledNormals::none, .depthOffset = true},
     inSharedBuffers({.quads = true, .edges = true, .flagged = true})},
    {"wireframe", {.lightCount = 2}, {.wireframe = true}},
    {"wireframe_of_points",
     {.color = PulledColor::points, .lights = PulledLights::headlight, .clipPlanes = true},
     inSharedBuffers({.wireframe = true})},
    {"wireframe_of_texels",
     {.color = PulledColor::mapped, .scalars = false},
     inSharedBuffers({.wireframe = true, .opacity = 0.6f})},
    {"wireframe_of_quads",
     {.color = PulledColor::cells, .normals = PulledNormals::none, .depthOffset = true},
     inSharedBuffers({.quads = true, .flagged = true, .wireframe = true})},
    {"wireframe_and_edges", {.backMaterial = true}, {.edges = true, .flagged = true, .wireframe = true}},
    {"wireframe_indexed", {}, {.indexed = true, .wireframe = true}, 0},
    {"back_clipped",
     {.lights = PulledLights::headlight, .backMaterial = true, .clipPlanes = true},
     kSharedBuffers},
    {"depth_offset", {.depthOffset = true}, {}},
    {"blocks", {.lightCount = 2, .blocks = true}, kSharedBuffers},
    {"blocks_of_points", {.color = PulledColor::points, .scalars = false, .blocks = true}, kSharedBuffers},
    {"blocks_of_cells", {.color = PulledColor::cells, .blocks = true}, inSharedBuffers({.quads = true})},
    {"blocks_of_maps",
     {.color = PulledColor::mapped, .lights = PulledLights::headlight, .blocks = true},
     kSharedBuffers},
    {"blocks_of_one_color",
     {.color = PulledColor::cells, .blocks = true},
     inSharedBuffers({.quads = true, .edges = true, .flagged = true, .overrides = true})},
    {"blocks_of_one_color_and_maps",
     {.color = PulledColor::mapped, .blocks = true},
     inSharedBuffers({.overrides = true})},
    {"blocks_of_two_sides", {.backMaterial = true, .blocks = true}, kSharedBuffers, 0},
};

class PulledPrograms : public testing::TestWithParam<PulledCase> {};

/// A bowl: both sides of its triangles are visible.
ProgramMesh pulledBowl() {
  ProgramMesh mesh = ball(12);
  mesh.indices.resize(mesh.indices.size() / 6 * 3);
  return mesh;
}

TEST_P(PulledPrograms, AreTraced) {
  const PulledCase& c = GetParam();
  const auto draw = [&](Gl gl) {
    beginFrame(gl);
    const GLuint program = makeProgram(gl, c.surface);
    const PulledMesh mesh(gl, pulledBowl(), c.way, c.surface.scalars);
    mesh.set(gl, program, perspectiveView(35), c.surface);
    mesh.draw(gl);
  };
  expectBoth(std::string("pulled_") + c.name, draw, c.draws);
}

INSTANTIATE_TEST_SUITE_P(All, PulledPrograms, testing::ValuesIn(kPulledCases),
                         [](const auto& info) { return std::string(info.param.name); });

/// Draws a bowl with these uniforms changed.
DrawProgram bowlWith(const std::function<void(Gl, GLuint)>& change, PulledSurface surface = {},
                     PulledWay way = {}) {
  return [=](Gl gl) {
    beginFrame(gl);
    const GLuint program = makeProgram(gl, surface);
    const PulledMesh mesh(gl, pulledBowl(), way, surface.scalars);
    mesh.set(gl, program, perspectiveView(35), surface);
    change(gl, program);
    mesh.draw(gl);
  };
}

TEST(PulledProgram, WithUniformsForOtherPrimitivesIsRasterised) {
  for (const auto& [name, value] : {std::pair{"vertex_pass", 1}, {"cellType", 1}, {"primitiveSize", 2}})
    expectSame(std::string("pulled_other_") + name,
               bowlWith([&, n = name, v = value](Gl gl, GLuint program) { setInteger(gl, program, n, v); }),
               0);
}

TEST(PulledProgram, ThatFitsNoFamilyIsRasterised) {
  const Outcome outcome =
      expectSame("pulled_unknown", bowlWith([](Gl, GLuint) {}, {.backMaterial = true, .blocks = true}), 0);
  EXPECT_EQ(outcome.statistics.rasterisedBecause[static_cast<size_t>(gl::Reason::program)], 1u);
}

/// Of a pixel that shows no edge neither colour nor depth changes; of others their opacity is written.
TEST(PulledProgram, OfWireframeIsTracedWithoutBlending) {
  const auto plain = [](Gl gl, GLuint) { gl.Disable(GL_BLEND); };
  expectSame("pulled_wireframe_plain", bowlWith(plain, {}, {.wireframe = true}), 1);
}

/// What lies between the edges is seen, in the order of drawing and by depth.
TEST(PulledProgram, OfWireframeShowsWhatLiesBehind) {
  const auto draw = [](Gl gl) {
    beginFrame(gl);
    const PulledSurface surface{.color = PulledColor::points};
    const GLuint program = makeProgram(gl, surface);
    const PulledMesh mesh(gl, pulledBowl(), {}, true);
    View view = perspectiveView(35);
    mesh.set(gl, program, view, surface);
    for (const int wireframe : {1, 0, 1}) {
      setInteger(gl, program, "wireframe", wireframe);
      setFloat(gl, program, "edgeWidth", wireframe ? 2.5f : 1);
      setMat4(gl, program, "MCDCMatrix", glm::mat4(view.clipFromEye * view.eyeFromObject));
      mesh.draw(gl);
      view.eyeFromObject = glm::scale(view.eyeFromObject, glm::dvec3(wireframe ? 0.8 : 1.5));
    }
  };
  expectBoth("pulled_wireframe_among_surfaces", draw, 3);
}

/// Rays from elsewhere would meet whole triangles.
TEST(PulledProgram, OfWireframeIsRasterisedUnderEffectsOfLight) {
  Settings settings = TracedContext::tracing();
  settings.shadows.enabled = true;
  const TracedContext traced(coreWish(), settings);
  bowlWith([](Gl, GLuint) {}, {}, {.wireframe = true})(traced.gl());
  traced.gl().Finish();
  EXPECT_EQ(traced.context().counts.statistics.drawsTraced, 0u);
}

TEST(PulledProgram, ThatBeginsElsewhereIsRasterised) {
  const auto later = [](Gl gl, GLuint program) { setInteger(gl, program, "vertexIdOffset", 3); };
  expectSame("pulled_elsewhere", bowlWith(later, {.color = PulledColor::cells}, {.verticesBefore = 6}), 0);
}

TEST(PulledProgram, WithCellsBeyondTheirValuesIsRasterised) {
  const auto beyond = [](Gl gl, GLuint program) { setInteger(gl, program, "cellIdOffset", 90); };
  const auto draw = bowlWith(beyond, {.color = PulledColor::cells}, {.quads = true});
  const TracedContext traced(coreWish());  // what the real OpenGL reads there is undefined
  draw(traced.gl());
  traced.gl().Finish();
  EXPECT_EQ(traced.context().counts.statistics.drawsTraced, 0u);
}

TEST(PulledProgram, ShowsChangesOfItsBuffers) {
  const auto draw = [](Gl gl) {
    beginFrame(gl);
    const PulledSurface surface{.color = PulledColor::cells};
    const GLuint program = makeProgram(gl, surface);
    const PulledMesh mesh(gl, pulledBowl(), inSharedBuffers({.quads = true}), true);
    mesh.set(gl, program, perspectiveView(35), surface);
    mesh.draw(gl);
    mesh.move(gl, 30, {1.6f, 0.2f, 0.1f});
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh.draw(gl);
    mesh.move(gl, 31, {0.1f, 1.5f, 0.4f});
    mesh.recolor(gl, 20);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh.draw(gl);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh.regroup(gl, 60), mesh.recolor(gl, 0);
    mesh.draw(gl);
  };
  expectBoth("pulled_changes", draw, 4);
}

TEST(PulledProgram, OfPointsAndLinesIsRasterised) {
  for (const GLenum mode : {GL_POINTS, GL_LINES}) {
    const auto draw = [&](Gl gl) {
      beginFrame(gl);
      const GLuint program = makeProgram(gl, PulledSurface{});
      const PulledMesh mesh(gl, pulledBowl(), {}, true);
      mesh.set(gl, program, perspectiveView(35), {});
      setInteger(gl, program, "cellType", mode == GL_POINTS ? 1 : 3);
      setInteger(gl, program, "primitiveSize", mode == GL_POINTS ? 1 : 2);
      gl.DrawArraysInstanced(mode, 0, 300, 1);
    };
    const Outcome outcome = expectSame("pulled_primitives", draw, 0);
    EXPECT_EQ(outcome.statistics.rasterisedBecause[static_cast<size_t>(
                  mode == GL_POINTS ? gl::Reason::points : gl::Reason::lines)],
              1u);
  }
}

class PulledMutants : public testing::TestWithParam<PulledCase> {};

TEST_P(PulledMutants, AreNotTakenForTheOriginal) {
  const PulledCase& c = GetParam();
  expectMutantsSeen(
      std::string("pulled_") + c.name,
      {{GL_VERTEX_SHADER, pulledVertexText(c.surface)}, {GL_FRAGMENT_SHADER, pulledFragmentText(c.surface)}},
      [&](Gl gl, GLuint program) {
        beginFrame(gl);
        const PulledMesh mesh(gl, pulledBowl(), c.way, c.surface.scalars);
        mesh.set(gl, program, perspectiveView(35), c.surface);
        mesh.draw(gl);
      });
}

INSTANTIATE_TEST_SUITE_P(
    Cases, PulledMutants,
    testing::Values(PulledCase{
        "points", {.color = PulledColor::points, .lights = PulledLights::headlight}, kSharedBuffers}),
    [](const auto& info) { return std::string(info.param.name); });
/// Label `program`: scripts/test --all.
INSTANTIATE_TEST_SUITE_P(
    MoreCases, PulledMutants,
    testing::Values(
        PulledCase{"cells",
                   {.color = PulledColor::cells, .normals = PulledNormals::cells, .lightCount = 2},
                   inSharedBuffers({.quads = true})},
        PulledCase{"flat",
                   {.normals = PulledNormals::none, .lights = PulledLights::positional, .depthOffset = true},
                   inSharedBuffers({.edges = true, .flagged = true})},
        PulledCase{"texels",
                   {.color = PulledColor::mapped, .scalars = false, .clipPlanes = true, .textured = true},
                   kSharedBuffers},
        PulledCase{"back", {.lightCount = 2, .backMaterial = true}, {}},
        PulledCase{"wireframe",
                   {.color = PulledColor::cells},
                   inSharedBuffers({.quads = true, .flagged = true, .wireframe = true})},
        PulledCase{"blocks", {.color = PulledColor::points, .blocks = true}, kSharedBuffers},
        PulledCase{"blocks_of_one_color",
                   {.color = PulledColor::cells, .blocks = true},
                   inSharedBuffers({.overrides = true})}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace gluray::test
