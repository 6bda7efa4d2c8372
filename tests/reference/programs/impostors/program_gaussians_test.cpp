// Point Gaussian's own look, whose opacity falls off as a gaussian: blended, summed, and over surfaces.
#include "tests/reference/layers/summer.h"
#include "tests/reference/programs/impostors/point_gaussian.h"
#include "tests/reference/programs/program_mutants.h"

#include <gtest/gtest.h>

#include <string>

namespace gluray::test {
namespace {

struct GaussianCase {
  const char* name;
  PointGaussian points;
  PointGaussianView view;
  GLenum destination = GL_ONE_MINUS_SRC_ALPHA;
  bool writesDepth = true;
  int draws = 1;
};
void PrintTo(const GaussianCase& c, std::ostream* out) { *out << c.name; }

constexpr PointGaussian kDiscs{.splats = false};
constexpr PointGaussian kInstances{.instances = true};
constexpr PointGaussian kOutlines{.look = PointGaussian::Look::outline, .instances = true, .fromZero = true};
constexpr PointGaussian kSprites{.look = PointGaussian::Look::sprite, .instances = true};

const GaussianCase kGaussianCases[] = {
    {"gaussians", {}, {.radius = 0.1f, .bounds = 3}},
    {"gaussians_parallel", {}, {.parallel = true, .radius = 0.1f, .bounds = 3}},
    {"gaussians_stretched", {}, {.stretch = {1.5f, 0.4f, 0.8f}, .radius = 0.1f, .bounds = 3}},
    {"gaussians_wide_angle", {}, {.radius = 0.07f, .field = 110, .bounds = 3}},
    {"gaussians_small", {}, {.stretch = {2, 0.5f, 1}, .radius = 0.006f, .bounds = 3}},
    {"gaussians_offset", {}, {.radius = 0.1f, .offset = -8, .bounds = 3}},
    {"gaussians_narrow", {}, {.radius = 0.1f, .bounds = 1}},
    {"gaussians_in_one_plane", {}, {.radius = 0.1f, .bounds = 3, .flat = true}},
    {"gaussians_one_color", {.oneColor = true}, {.radius = 0.1f, .bounds = 3, .opacity = 0.6f}},
    {"gaussians_added", {}, {.radius = 0.1f, .bounds = 3}, GL_ONE},
    {"gaussians_added_without_depth", {}, {.radius = 0.1f, .bounds = 3, .alpha = 0.7f}, GL_ONE, false},
    {"gaussians_without_depth",
     {},
     {.radius = 0.1f, .bounds = 3, .alpha = 0.7f},
     GL_ONE_MINUS_SRC_ALPHA,
     false},
    {"gaussians_in_boxes", {}, {.radius = 0.1f, .bounds = 0.7f}, GL_ONE_MINUS_SRC_ALPHA, true, 0},
    {"gaussians_lowpass", {}, {.radius = 0.05f, .lowpass = 0.01f, .bounds = 3}},
    {"gaussians_no_covariance", {}, {.radius = 0.05f, .lowpass = -0.0001f, .bounds = 3}, GL_ONE, true, 0},
    // Vertices of alpha 0 would write no depth.
    {"gaussians_clear", {}, {.radius = 0.1f, .bounds = 3, .alpha = 0}, GL_ONE_MINUS_SRC_ALPHA, true, 0},
    // At the corners opacities are 0 in floats.
    {"gaussians_wide", {}, {.radius = 0.01f, .bounds = 12}, GL_ONE_MINUS_SRC_ALPHA, true, 0},
    {"gaussians_invisible", {.oneColor = true}, {.radius = 0.1f, .bounds = 3, .opacity = 0}, GL_ONE, true, 0},
    {"instances", kInstances, {.radius = 0.1f, .bounds = 3}},
    {"instances_parallel", kInstances, {.parallel = true, .radius = 0.1f, .bounds = 3}},
    {"instances_one_color", {.instances = true, .oneColor = true}, {.radius = 0.1f, .bounds = 3}},
    {"sprites", kSprites, {.radius = 0.15f, .bounds = 1.2f, .ambient = 0}},
    {"sprites_parallel", kSprites, {.parallel = true, .radius = 0.15f, .bounds = 1.2f, .ambient = 0}},
    {"sprites_stretched",
     kSprites,
     {.stretch = {1.5f, 0.4f, 0.8f}, .radius = 0.15f, .bounds = 1.2f, .ambient = 0}},
    {"sprites_lowpass", kSprites, {.radius = 0.05f, .lowpass = 2e-5f, .bounds = 1.2f, .ambient = 0}},
    {"sprites_small", kSprites, {.radius = 0.02f, .bounds = 1.5f, .ambient = 0}},
    {"sprites_without_depth",
     kSprites,
     {.radius = 0.15f, .bounds = 1.2f, .ambient = 0},
     GL_ONE_MINUS_SRC_ALPHA,
     false},
    {"sprites_in_ambient_light",
     kSprites,
     {.radius = 0.15f, .bounds = 1.2f},
     GL_ONE_MINUS_SRC_ALPHA,
     true,
     0},
    {"sprites_from_zero",
     {.look = PointGaussian::Look::sprite, .instances = true, .fromZero = true},
     {.radius = 0.15f, .bounds = 1.2f, .ambient = 0}},
    {"instances_from_zero", {.instances = true, .fromZero = true}, {.radius = 0.1f, .bounds = 3}},
    {"instances_below_zero",
     {.instances = true, .fromZero = true},
     {.radius = 0.1f, .bounds = 3, .blue = -0.5f},
     GL_ONE_MINUS_SRC_ALPHA,
     true,
     0},
    {"outlines", kOutlines, {.radius = 0.15f, .bounds = 1.2f, .ambient = 0}},
    {"outlines_parallel", kOutlines, {.parallel = true, .radius = 0.2f, .bounds = 1.3f, .ambient = 0}},
    {"outlines_small", kOutlines, {.radius = 0.03f, .bounds = 2, .ambient = 0}},
    {"outlines_without_depth",
     {.look = PointGaussian::Look::outline, .instances = true, .oneColor = true},
     {.stretch = {1.5f, 0.4f, 0.8f}, .radius = 0.15f, .bounds = 1.2f, .ambient = 0},
     GL_ONE_MINUS_SRC_ALPHA,
     false},
    {"discs", kDiscs, {.radius = 0.3f, .bounds = 3}},
    {"discs_parallel", kDiscs, {.parallel = true, .radius = 0.3f, .bounds = 3}},
    {"discs_wide_angle", kDiscs, {.radius = 0.2f, .field = 110, .bounds = 3}},
    {"discs_added", kDiscs, {.radius = 0.3f, .bounds = 3, .alpha = 0.7f}, GL_ONE, false},
    {"discs_wide", kDiscs, {.radius = 0.3f, .bounds = 7}, GL_ONE_MINUS_SRC_ALPHA, true, 0},
};

/// Per-instance arrays need OpenGL 3.3.
ContextWish wishOf(const PointGaussian& points) { return points.instances ? coreWish(3, 3) : coreWish(); }

void blend(Gl gl, GLenum destination, bool writesDepth) {
  gl.Enable(GL_BLEND), gl.BlendFunc(GL_SRC_ALPHA, destination), gl.DepthMask(writesDepth);
}

class ProgramGaussians : public testing::TestWithParam<GaussianCase> {};

TEST_P(ProgramGaussians, AreWhatTheProgramComputes) {
  const GaussianCase& c = GetParam();
  expectBoth(
      c.name,
      [&](Gl gl) {
        const GLuint program =
            linkImpostors(gl, vertexText(c.points), geometryText(c.points), fragmentText(c.points));
        beginFrame(gl);
        preparePointGaussian(gl, program, c.points, c.view);
        blend(gl, c.destination, c.writesDepth);
        drawPrepared(gl, c.points);
        gl.DepthMask(GL_TRUE);
      },
      c.draws, wishOf(c.points));
}

INSTANTIATE_TEST_SUITE_P(Cases, ProgramGaussians, testing::ValuesIn(kGaussianCases),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(ProgramGaussian, WithoutBlendingAreTracedAsOpaque) {
  for (const bool splats : {true, false})
    expectBoth(
        std::string("gaussians_opaque_") + (splats ? "splats" : "discs"),
        [&](Gl gl) {
          drawPointGaussian(gl, {.splats = splats}, {.radius = splats ? 0.1f : 0.3f, .bounds = 3});
        },
        1);
}

/// Pairs at the same depth, as of symmetrical point sets, count twice.
TEST(ProgramGaussian, AreSummed) {
  for (const bool splats : {true, false})
    for (const auto look : {PointGaussian::Look::gaussian, PointGaussian::Look::round}) {
      const PointGaussian points{.look = look, .splats = splats, .sums = true};
      const std::string name = std::string("gaussians_summed_") + (splats ? "splats" : "discs") +
                               (look == PointGaussian::Look::round ? "_round" : "");
      expectBoth(
          name,
          [&](Gl gl) {
            Summer summer(gl);
            const GLuint program =
                linkImpostors(gl, vertexText(points), geometryText(points), fragmentText(points));
            const PointGaussianView view{
                .radius = splats ? 0.15f : 0.4f, .bounds = 3, .opacity = 0.8f, .flat = true};
            summer.last = [&] {
              preparePointGaussian(gl, program, points, view);
              drawPrepared(gl, points);
            };
            summer.frame({Layer{.mesh = ball(16), .opacity = 1}});
          },
          2);
    }
}

/// Other draws with instances than strips of four vertices.
TEST(ProgramGaussian, OfInstancesAreLeftToTheRealOpenGlUnlessEachIsAWholeBillboard) {
  for (const bool few : {true, false})
    expectBoth(
        std::string("gaussians_instances_") + (few ? "three_corners" : "other_corners"),
        [&](Gl gl) {
          const GLuint program =
              linkImpostors(gl, vertexText(kInstances), geometryText(kInstances), fragmentText(kInstances));
          beginFrame(gl);
          preparePointGaussian(gl, program, kInstances, {.radius = 0.1f, .bounds = 3});
          gl.DrawArraysInstanced(GL_TRIANGLE_STRIP, few ? 0 : 1, few ? 3 : 4, kImpostors);
          gl.DrawArrays(GL_POINTS, 0, 4);
        },
        0, coreWish(3, 3));
}

TEST(ProgramGaussian, OfInstancesBeginAtTheBaseInstance) {
  expectBoth(
      "gaussians_base_instance",
      [](Gl gl) {
        const GLuint program =
            linkImpostors(gl, vertexText(kInstances), geometryText(kInstances), fragmentText(kInstances));
        beginFrame(gl);
        preparePointGaussian(gl, program, kInstances, {.radius = 0.1f, .bounds = 3});
        gl.DrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 4, 20, 30);
      },
      1, coreWish(4, 5));
}

TEST(ProgramGaussian, MutantsAreNotTakenForThem) {
  for (const auto& [name, points] :
       {std::pair("splats", PointGaussian{}), std::pair("discs", kDiscs), std::pair("instances", kInstances),
        std::pair("sprites", kSprites), std::pair("outlines", kOutlines)}) {
    ShaderTexts texts{{GL_VERTEX_SHADER, vertexText(points)}, {GL_FRAGMENT_SHADER, fragmentText(points)}};
    if (!points.instances) texts.emplace_back(GL_GEOMETRY_SHADER, geometryText(points));
    expectMutantsSeen(
        std::string("gaussian_mutants_") + name, texts,
        [&, points = points](Gl gl, GLuint program) {
          beginFrame(gl);
          preparePointGaussian(
              gl, program, points,
              {.radius = points.splats ? 0.1f : 0.3f, .offset = -8, .bounds = 3, .ambient = 0});
          blend(gl, GL_ONE_MINUS_SRC_ALPHA, true);
          drawPrepared(gl, points);
        },
        wishOf(points));
  }
}

}  // namespace
}  // namespace gluray::test
