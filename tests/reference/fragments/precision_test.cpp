// Surfaces for which rays cannot reproduce OpenGL's image: coplanar surfaces, and triangles much larger
// than their visible part.
#include "tests/reference/programs/program_stage.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace gluray::test {
namespace {

constexpr scenes::Tolerance kSameImage{1, 0, 1e-7f, "both are drawn by the real OpenGL"};
constexpr scenes::Tolerance kEdges{1, 0.002, 1e-6f, "edges fall on either side of a pixel's centre"};

/// A rectangle in the plane z = 0, of n x n squares.
ProgramMesh squaresOf(glm::vec2 lower, glm::vec2 upper, int n = 1) {
  ProgramMesh mesh;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) {
      const glm::vec2 at = glm::mix(lower, upper, glm::vec2(x, y) / static_cast<float>(n));
      mesh.positions.emplace_back(at, 0);
      mesh.normals.emplace_back(0, 0, 1);
      mesh.colors.push_back(0xFFFFFFFFu);
      mesh.texcoords.emplace_back(0);
    }
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const auto first = static_cast<GLuint>(y * (n + 1) + x), above = first + static_cast<GLuint>(n) + 1;
      for (const GLuint i : {first, first + 1, above + 1, first, above + 1, above}) mesh.indices.push_back(i);
    }
  return mesh;
}

struct Rectangle {
  glm::vec2 lower, upper;
  glm::vec3 color;
};

void drawRectangles(Gl gl, const std::vector<Rectangle>& all, const View& view, GLenum depthFunc) {
  const Surface surface{.lights = Surface::Lights::none};
  const GLuint program = makeProgram(gl, surface);
  beginFrame(gl);
  gl.DepthFunc(depthFunc);
  for (const Rectangle& one : all) {
    const ProgramMesh mesh = squaresOf(one.lower, one.upper);
    const Upload up = upload(gl, mesh, program);
    gl.UseProgram(program);
    setAll(gl, program, view, surface);
    setVec3(gl, program, "diffuseColorUniform", one.color);
    gl.BindVertexArray(up.array);
    gl.DrawRangeElements(GL_TRIANGLES, 0, 3, mesh.count(), GL_UNSIGNED_INT, nullptr);
  }
}

const std::vector<Rectangle> kUponEachOther = {{{-1, -1}, {1, 1}, {1, 0, 0}},
                                               {{-0.3f, -0.2f}, {0.4f, 0.35f}, {0, 1, 0}},
                                               {{0.1f, -0.7f}, {0.8f, 0.1f}, {0, 0, 1}}};

TEST(Precision, OverlappingCoplanarSurfacesAreShownInTheOrderOfDrawing) {
  for (const GLenum func : {GL_LESS, GL_LEQUAL}) {
    for (const View& view : {perspectiveView(), perspectiveView(25), parallelView(), parallelView(40)})
      expectSame(
          "coplanar", [&](Gl gl) { drawRectangles(gl, kUponEachOther, view, func); }, 0, {}, kSameImage);
  }
}

TEST(Precision, AdjacentCoplanarSurfacesAreTraced) {
  const std::vector<Rectangle> all = {{{-1, -1}, {0.25f, 1}, {1, 0, 0}}, {{0.25f, -1}, {1, 1}, {0, 1, 0}}};
  expectSame(
      "neighbours", [&](Gl gl) { drawRectangles(gl, all, perspectiveView(25), GL_LEQUAL); }, 2, {}, kEdges);
}

TEST(Precision, HugeTrianglesAreRasterisedAndTheOthersTraced) {
  const std::vector<Rectangle> all = {{{-1e6f, -1e6f}, {-0.9f, 1e6f}, {1, 0, 0}},
                                      {{-0.6f, -1}, {0.8f, 1}, {0, 0, 1}},
                                      {{1, -1e6f}, {1e6f, 1e6f}, {0, 1, 0}}};
  expectSame(
      "huge", [&](Gl gl) { drawRectangles(gl, all, parallelView(10), GL_LEQUAL); }, 1, {}, kEdges);
}

}  // namespace
}  // namespace gluray::test
